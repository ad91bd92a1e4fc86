// The JSON reports of `bench`.
#include "tests/support/packing.hpp"
#include "tests/support/run_edgeshade.hpp"
#include "tests/support/temp_folder.hpp"

#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

class BenchReport : public testing::Test {
  protected:
    BenchReport() : input_(folder_.write("in.glb", variedScene().glb())) {}

    Json report(const std::vector<std::string>& more) const {
        std::vector<std::string> arguments = {"bench",  input_,  "--frames", "3",
                                              "--size", "32x24", "--report", "-"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const ProcessResult result = runEdgeshade(arguments);
        EXPECT_EQ(result.status, 0) << result.err;
        return Json::parse(result.out);
    }

    static void expectContractKeys(const Json& result) {
        for (const char* key : {"vendor", "renderer", "version", "extensions"})
            EXPECT_TRUE(result["device"][key].is_string()) << key;
        EXPECT_EQ(result["size"], Json({32, 24}));
        EXPECT_EQ(result["frames"], 3);
        EXPECT_TRUE(result["settings"].contains("shadows"));
        for (const char* key : {"median", "p95", "max"})
            EXPECT_GT(result["frame_ms"][key], 0.0) << key;
        for (const char* key : {"ambient", "silhouette", "rasterise", "lit"})
            EXPECT_TRUE(result["stage_ms"][key].is_number()) << key;
        EXPECT_TRUE(result["vertex_runs"].is_number_unsigned());
        EXPECT_TRUE(result["bytes_gpu"].is_number_unsigned());
        EXPECT_TRUE(result["timing"] == "query" || result["timing"] == "finish" ||
                    result["timing"] == "processor");
    }

    TempFolder folder_;
    std::string input_;
};

TEST_F(BenchReport, OfOneSettingHasTheKeysOfTheContract) {
    const Json result = report({});
    expectContractKeys(result);
    EXPECT_GT(result["vertex_runs"], 0);
    EXPECT_GT(result["bytes_gpu"], 0);
    EXPECT_EQ(result["light"], "rests");
    EXPECT_TRUE(result["warnings"].is_array());
}

TEST_F(BenchReport, OfSeveralSettingsHasOneOfEachAndRatios) {
    const Json both = report({"--against", "shadows=map,map-size=64", "--against", "shadows=none"});
    ASSERT_EQ(both["results"].size(), 3u);
    for (const Json& result : both["results"])
        expectContractKeys(result);
    EXPECT_EQ(both["results"][0]["name"], "volumes");
    EXPECT_EQ(both["results"][1]["name"], "shadows=map,map-size=64");
    EXPECT_EQ(both["results"][1]["settings"]["map-size"], 64);
    EXPECT_EQ(both["results"][1]["bytes"]["sides"], 0);
    EXPECT_EQ(both["results"][1]["vertex_runs"], 0) << "the light rests, the map is kept";
    EXPECT_EQ(both["results"][2]["bytes_gpu"], 0);
    ASSERT_EQ(both["ratios"].size(), 2u);
    EXPECT_EQ(both["ratios"][0]["name"], "shadows=map,map-size=64");
    for (const Json& ratio : both["ratios"]) {
        EXPECT_LE(ratio["min"], ratio["median"]);
        EXPECT_LE(ratio["median"], ratio["max"]);
    }
}

TEST_F(BenchReport, SaysHowItWasTimed) {
    for (const char* timing : {"finish", "processor"})
        EXPECT_EQ(report({"--timing", timing})["timing"], timing);
}

TEST_F(BenchReport, AMovingLightDrawsMapsAnew) {
    const Json both = report({"--light-moves", "--against", "shadows=map,map-size=64"});
    EXPECT_EQ(both["results"][1]["light"], "moves");
    EXPECT_GT(both["results"][1]["vertex_runs"], 0);
    EXPECT_GT(both["results"][1]["stage_ms"]["map"], 0.0);
}

TEST_F(BenchReport, CirclesAreOfLightsThatMove) {
    const auto said = [&](std::vector<std::string> words) {
        words.insert(words.begin(), {"bench", input_, "--frames", "1"});
        const ProcessResult result = runEdgeshade(words);
        EXPECT_EQ(result.status, 1);
        return result.err;
    };
    EXPECT_NE(said({"--light-circle", "1"}).find("--light-moves"), std::string::npos);
    for (const char* size : {"0", "-1", "11", "nan", "inf", "wide"})
        EXPECT_NE(said({"--light-moves", "--light-circle", size}).find("--light-circle"),
                  std::string::npos)
            << size;
}

TEST_F(BenchReport, SeveralSizesAreSeveralResults) {
    const ProcessResult result =
        runEdgeshade({"bench", input_, "--frames", "1", "--sizes", "16x16,32x24", "--report", "-"});
    ASSERT_EQ(result.status, 0) << result.err;
    const Json json = Json::parse(result.out);
    ASSERT_EQ(json["results"].size(), 2u);
    EXPECT_EQ(json["results"][0]["size"], Json({16, 16}));
    EXPECT_EQ(json["results"][1]["size"], Json({32, 24}));
    EXPECT_TRUE(json["ratios"].empty());
}

TEST_F(BenchReport, APictureThatIsTooLargeIsNotPossibleHere) {
    const ProcessResult result =
        runEdgeshade({"bench", input_, "--frames", "1", "--size", "65536x16"});
    EXPECT_EQ(result.status, 3);
    EXPECT_NE(result.err.find("65536x16"), std::string::npos);
}

TEST_F(BenchReport, TheTableNamesEverySetting) {
    const ProcessResult result = runEdgeshade(
        {"bench", input_, "--frames", "1", "--size", "16x16", "--against", "shadows=none"});
    EXPECT_EQ(result.status, 0);
    for (const char* word : {"volumes", "shadows=none", "median", "silhouette", "16x16"})
        EXPECT_NE(result.out.find(word), std::string::npos) << word;
}

} // namespace
} // namespace edgeshade::test
