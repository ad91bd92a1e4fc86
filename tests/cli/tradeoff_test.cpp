// The program `tradeoff`. Its measurements are tested with the code that makes them.
#include "tests/support/packing.hpp"
#include "tests/support/run_edgeshade.hpp"
#include "tests/support/temp_folder.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <sstream>

namespace edgeshade::test {
namespace {

/// Boxes around the middle of a floor.
GltfBuilder boxesOnAFloor() {
    GltfBuilder gltf;
    gltf.addShapeNode(box(glm::vec3(6.0f, 0.1f, 6.0f)));
    const int mesh = gltf.addShape(box(glm::vec3(0.3f, 1.0f, 0.3f)));
    for (const double x : {-1.5, 0.0, 1.5})
        for (const double z : {-1.5, 0.0, 1.5})
            gltf.addNode({{"mesh", mesh}, {"translation", {x, 1.1, z}}});
    return gltf;
}

class Tradeoff : public testing::Test {
  protected:
    Tradeoff() : input_(folder_.write("in.glb", variedScene().glb())) {}

    /// It prepares some forty settings, which takes longer than other programs' timeout.
    static ProcessResult ended(const std::vector<std::string>& arguments) {
        return EdgeshadeProcess(arguments).wait(120.0);
    }

    ProcessResult run(const std::vector<std::string>& more) const { return runOf(input_, more); }

    static ProcessResult runOf(const std::string& scene, const std::vector<std::string>& more) {
        std::vector<std::string> arguments = {"tradeoff",      scene, "--frames", "2",
                                              "--views",       "1",   "--size",   "48x32",
                                              "--largest-map", "512", "--report", "-"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return ended(arguments);
    }

    TempFolder folder_;
    std::string input_;
};

using LongTradeoff = Tradeoff;

TEST_F(Tradeoff, RowsHaveTheKeysOfTheContractAndTheFrontIsOne) {
    const std::string plot = folder_ / "plot.svg";
    const ProcessResult result = run({"--plot", plot});
    ASSERT_EQ(result.status, 0) << result.err;
    const Json report = Json::parse(result.out);
    ASSERT_GE(report["rows"].size(), 10u);
    for (const Json& row : report["rows"]) {
        EXPECT_TRUE(row["name"].is_string());
        EXPECT_TRUE(row["settings"].contains("shadows"));
        for (const char* key :
             {"frame_ms", "bytes_gpu", "wrong_image_percent", "wrong_image_beyond_1px_percent"})
            EXPECT_TRUE(row[key].is_number()) << key;
        EXPECT_GE(row["rounds"], 1);
        EXPECT_EQ(row["frames"], 2); // as requested: nothing can be dropped earlier
        EXPECT_EQ(row["views"], 1);
        EXPECT_EQ(row["dominated_early"], false);
        EXPECT_GE(row["frame_ms_below"], row["frame_ms"]);
        EXPECT_GE(row["wrong_image_percent_below"], row["wrong_image_percent"]);
        bool beaten = false;
        for (const Json& other : report["rows"])
            beaten = beaten || (other["frame_ms"] < row["frame_ms"] &&
                                other["wrong_image_percent"] < row["wrong_image_percent"]);
        EXPECT_FALSE(beaten && row["pareto"].get<bool>()) << row["name"];
    }
    EXPECT_FALSE(report.contains("take"));
    const Bytes svg = readFile(plot);
    EXPECT_NE(std::string(svg.begin(), svg.end()).find("<title>map 512\n"), std::string::npos);
}

TEST_F(Tradeoff, SaysTheSettingToTakeAsOptionsThatRenderTakes) {
    const ProcessResult result = run({"--budget-ms", "1000000", "--max-wrong-percent", "100"});
    ASSERT_EQ(result.status, 0) << result.err;
    const Json take = Json::parse(result.out)["take"];
    std::vector<std::string> arguments = {"render", input_, folder_ / "out.png", "--size", "16x16"};
    std::istringstream words(take["options"].get<std::string>());
    for (std::string word; words >> word;)
        arguments.push_back(word);
    EXPECT_GT(arguments.size(), 6u);
    const ProcessResult rendered = runEdgeshade(arguments);
    EXPECT_EQ(rendered.status, 0) << rendered.err;
}

TEST_F(Tradeoff, CoarserCastersAreRowsAndTheirOptionsWorkInRender) {
    const ProcessResult result = run({"--caster-error", "0.5", "--cast-masked"});
    ASSERT_EQ(result.status, 0) << result.err;
    std::size_t simplified = 0, flat = 0, welded = 0;
    const Json report = Json::parse(result.out);
    for (const Json& row : report["rows"]) {
        const std::string options = row["options"];
        const Json& settings = row["settings"];
        const bool own = options.find("--caster-error 0.5") != std::string::npos;
        EXPECT_EQ(own, settings["caster-error"] == 0.5) << options;
        EXPECT_NE(options.find("--cast-masked"), std::string::npos);
        EXPECT_EQ(settings["cast-masked"], true);
        simplified += !own && settings["caster-error"] > 0.0;
        flat += settings["flat-tolerance"] > 0.0;
        welded += settings["weld-tolerance"] > 0.0;
        if (own && settings["flat-tolerance"] == 0.0) continue;
        std::vector<std::string> arguments = {"render", input_, folder_ / "out.png", "--size",
                                              "16x16"};
        std::istringstream words(options);
        for (std::string word; words >> word;)
            arguments.push_back(word);
        const ProcessResult rendered = runEdgeshade(arguments);
        EXPECT_EQ(rendered.status, 0) << rendered.err;
    }
    EXPECT_EQ(simplified, 3u);
    EXPECT_EQ(flat, 3u);
    EXPECT_EQ(welded, 1u);
}

TEST_F(LongTradeoff, OfEightLampsShadowsForSomeAreRowsJudgedByAnOracleOfAll) {
    std::vector<std::string> arguments = {"--light-range", "9"};
    for (int i = 0; i < 8; ++i) {
        const double turn = 0.25 * M_PI * i;
        std::ostringstream lamp;
        lamp << 3.0 * std::cos(turn) << ",2.5," << 3.0 * std::sin(turn)
             << ":#ffffff:" << 2.0 - 0.05 * i;
        arguments.insert(arguments.end(), {"--light", lamp.str()});
    }
    const std::string scene = folder_.write("boxes.glb", boxesOnAFloor().glb());
    const ProcessResult result = runOf(scene, arguments);
    ASSERT_EQ(result.status, 0) << result.err;
    const Json report = Json::parse(result.out);
    std::map<std::string, Json> rows;
    for (const Json& row : report["rows"])
        rows[row["name"].get<std::string>()] = row;
    for (const char* name : {"volumes", "primitive map", "1 shadowed light", "4 shadowed lights",
                             "map 512", "paraboloid 512", "no shadows"})
        ASSERT_TRUE(rows.contains(name)) << name;
    const auto wrong = [&](const char* name) -> double {
        return rows[name]["wrong_image_percent"];
    };
    EXPECT_LT(wrong("volumes"), 1.0);
    EXPECT_LT(wrong("primitive map"), 1.0);
    EXPECT_GT(wrong("4 shadowed lights"), 2.0 * wrong("volumes") + 1.0);
    EXPECT_GE(wrong("1 shadowed light"), wrong("4 shadowed lights"));
    EXPECT_GE(wrong("no shadows"), wrong("1 shadowed light"));
    EXPECT_EQ(rows["4 shadowed lights"]["settings"]["shadowed-lights"], 4);
    EXPECT_NE(rows["4 shadowed lights"]["options"].get<std::string>().find("--shadowed-lights 4"),
              std::string::npos);
    for (const auto& [name, row] : rows)
        EXPECT_GT(row["frame_ms"], 0.0) << name;
}

TEST_F(Tradeoff, WhereNoSettingWillDoItSaysSoAfterTheReport) {
    const ProcessResult result = run({"--budget-ms", "0.000001"});
    EXPECT_EQ(result.status, 3);
    EXPECT_TRUE(Json::parse(result.out)["take"].is_null());
    EXPECT_NE(result.err.find("No setting stays within"), std::string::npos);
}

TEST_F(Tradeoff, ACameraOfYoursIsTheOnlyView) {
    const ProcessResult result =
        ended({"tradeoff", input_, "--frames", "1", "--size", "16x16", "--largest-map", "512",
               "--camera-from", "9,9,9", "--camera-to", "0,0,0", "--report", "-"});
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(Json::parse(result.out)["views"], 1);
}

TEST_F(Tradeoff, WithoutTimeAllRowsGetOneFrameAndOneView) {
    const ProcessResult result = ended({"tradeoff", input_, "--size", "48x32", "--largest-map",
                                        "512", "--time-limit", "0.001", "--report", "-"});
    ASSERT_EQ(result.status, 0) << result.err;
    const Json report = Json::parse(result.out);
    EXPECT_EQ(report["time_limit"], 0.001);
    EXPECT_GT(report["seconds"], 0.001);
    for (const Json& row : report["rows"]) {
        EXPECT_EQ(row["frames"], 1) << row["name"];
        EXPECT_EQ(row["views"], 1) << row["name"];
    }
}

TEST_F(Tradeoff, WhatIsDroppedEarlyStaysInTheReportAndIsNotOnTheFront) {
    const ProcessResult result =
        ended({"tradeoff", input_, "--size", "16x16", "--largest-map", "512", "--frames", "16",
               "--views", "4", "--timing", "processor", "--report", "-"});
    ASSERT_EQ(result.status, 0) << result.err;
    const Json report = Json::parse(result.out);
    EXPECT_EQ(report["frames"], 16);
    EXPECT_EQ(report["views"], 4);
    for (const Json& row : report["rows"]) {
        EXPECT_EQ(row["dominated_early"], row.contains("dominated_by"));
        if (row["dominated_early"]) {
            EXPECT_FALSE(row["pareto"]) << row["name"];
            EXPECT_LE(row["frames"], 16);
        } else {
            EXPECT_EQ(row["frames"], 16) << row["name"];
            EXPECT_EQ(row["views"], 4) << row["name"];
        }
    }
}

TEST_F(Tradeoff, AnotherSettingIsOneMoreRow) {
    const ProcessResult result = run({"--against", "shadows=map,map-size=300"});
    ASSERT_EQ(result.status, 0) << result.err;
    const Json last = Json::parse(result.out)["rows"].back();
    EXPECT_EQ(last["name"], "shadows=map,map-size=300");
    EXPECT_EQ(last["settings"]["map-size"], 300);
}

} // namespace
} // namespace edgeshade::test
