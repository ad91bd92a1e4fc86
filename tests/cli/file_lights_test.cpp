// Lights of the file and from the command line: --lights, --light and --sun with colours and
// intensities.
#include "tests/support/gltf_builder.hpp"
#include "tests/support/run_edgeshade.hpp"
#include "tests/support/temp_folder.hpp"

#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

/// A box with this many spots of the file above it.
std::string sceneOfSpots(const TempFolder& folder, int count) {
    GltfBuilder gltf;
    gltf.addShapeNode(box(glm::vec3(1.0f)));
    gltf.useExtension("KHR_lights_punctual");
    gltf.json["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "spot"},
         {"color", {1.0, 0.5, 0.25}},
         {"intensity", 20},
         {"range", 9},
         {"spot", {{"innerConeAngle", 0.1}, {"outerConeAngle", 0.3}}}}};
    for (int i = 0; i < count; ++i)
        gltf.addNode({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}},
                      {"translation", {0, 1, 4}}});
    return folder.write("spots.glb", gltf.glb());
}

class FileLights : public testing::Test {
  protected:
    ProcessResult render(const std::vector<std::string>& more, int spots = 1) {
        std::vector<std::string> arguments = {
            "render",   sceneOfSpots(folder_, spots), folder_ / "out.png", "--size", "96x64",
            "--report", folder_ / "report.json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return runEdgeshade(arguments);
    }

    Json lights(const std::vector<std::string>& more) {
        const ProcessResult result = render(more);
        EXPECT_EQ(result.status, 0) << result.err;
        const Bytes bytes = readFile(folder_ / "report.json");
        return Json::parse(bytes.begin(), bytes.end())["lights"];
    }

    Bytes picture(const std::vector<std::string>& more) {
        const ProcessResult result = render(more);
        EXPECT_EQ(result.status, 0) << result.err;
        return readFile(folder_ / "out.png");
    }

    TempFolder folder_;
};

} // namespace

TEST_F(FileLights, AreUsedUnlessLightsAreAskedFor) {
    const Json ofFile = lights({});
    ASSERT_EQ(ofFile.size(), 1u);
    EXPECT_EQ(ofFile[0]["position"], (Json{0.0, 1.0, 4.0, 1.0}));
    EXPECT_EQ(ofFile[0]["range"], 9.0);
    EXPECT_EQ(ofFile[0]["color"], (Json{1.0, 0.5, 0.25}));
    EXPECT_EQ(ofFile[0]["intensity"], 20.0);
    EXPECT_EQ(ofFile[0]["cone"]["axis"], (Json{0.0, 0.0, -1.0}));
    EXPECT_NEAR(ofFile[0]["cone"]["outer"].get<double>(), 0.3 * 180.0 / M_PI, 1e-9);
    EXPECT_EQ(lights({"--lights", "file"}), ofFile);
    EXPECT_EQ(lights({"--lights", "default"})[0]["position"][3], 0.0);
    const Json typed = lights({"--sun", "0,1,0"});
    ASSERT_EQ(typed.size(), 1u);
    EXPECT_EQ(typed[0]["position"], (Json{0.0, 1.0, 0.0, 0.0}));
    EXPECT_FALSE(typed[0].contains("intensity"));
    EXPECT_NE(picture({}), picture({"--lights", "default"}));
}

TEST_F(FileLights, GoWithOneAnotherOrWithTypedOnes) {
    for (const char* typed : {"--light", "--sun"}) {
        const ProcessResult result = render({"--lights", "file", typed, "1,2,3"});
        EXPECT_EQ(result.status, 1);
        EXPECT_NE(result.err.find("--lights"), std::string::npos) << result.err;
    }
}

TEST_F(FileLights, OfMoreThanAPictureHasTheFirstAreDrawn) {
    const ProcessResult result = render({"--shadowed-lights", "0"}, 1001);
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.err.find("has 1001 lights, but a picture has at most 1000"), std::string::npos)
        << result.err;
}

TEST_F(FileLights, TypedOnesHaveColoursAndIntensities) {
    const Json lamp = lights({"--light", "1,2,3:#ff8000:12.5"})[0];
    EXPECT_EQ(lamp["color"][0], 1.0);
    EXPECT_NEAR(lamp["color"][1].get<double>(), 0.21586, 1e-4) << "sRGB made linear";
    EXPECT_EQ(lamp["color"][2], 0.0);
    EXPECT_NEAR(lamp["intensity"].get<double>(), 12.5, 1e-5);
    const Json dim = lights({"--light", "1,2,3:#808080"})[0];
    EXPECT_FALSE(dim.contains("intensity")) << "it doesn't fall off";
    EXPECT_NEAR(dim["color"][0].get<double>(), 0.21586, 1e-4);
    const Json sun = lights({"--sun", "0,1,0:#ffffff:3"})[0];
    EXPECT_NEAR(sun["intensity"].get<double>(), 3.0, 1e-5);
}

TEST_F(FileLights, WrongColoursAndIntensitiesAreNamed) {
    for (const char* wrong : {"1,2,3:", "1,2,3:red", "1,2,3:#ff80", "1,2,3:#ff80gg",
                              "1,2,3:#-1-1-1", "1,2,3:#ffffff:", "1,2,3:#ffffff:-1",
                              "1,2,3:#ffffff:nan", "1,2,3:#ffffff:1e300", "1,2,3:#ffffff:1:2"}) {
        const ProcessResult result = render({"--light", wrong});
        EXPECT_EQ(result.status, 1) << wrong;
        EXPECT_NE(result.err.find("--light"), std::string::npos) << result.err;
    }
}

TEST_F(FileLights, AreComparedWhereTheyAreAskedFor) {
    for (const std::vector<std::string>& asked :
         {std::vector<std::string>{"--camera-from", "3,3,6"},
          {"--lights", "file", "--views", "2"}}) {
        std::vector<std::string> arguments = {"compare",  sceneOfSpots(folder_, 1),
                                              "--size",   "120x80",
                                              "--report", folder_ / "report.json"};
        arguments.insert(arguments.end(), asked.begin(), asked.end());
        const ProcessResult result = runEdgeshade(arguments);
        if (result.status == 3) GTEST_SKIP() << "built without an oracle";
        ASSERT_EQ(result.status, 0) << result.err;
        const Bytes bytes = readFile(folder_ / "report.json");
        const Json report = Json::parse(bytes.begin(), bytes.end());
        EXPECT_EQ(report["wrong_image_beyond_1px_not_tied"], 0);
        EXPECT_EQ(report["lights"].size(), 1u);
    }
}

TEST_F(FileLights, AreMeasuredAndListed) {
    const std::string file = sceneOfSpots(folder_, 2);
    const ProcessResult bench =
        runEdgeshade({"bench", file, "--size", "64x48", "--frames", "2", "--warm-up", "0",
                      "--report", folder_ / "bench.json"});
    ASSERT_EQ(bench.status, 0) << bench.err;
    const Bytes bytes = readFile(folder_ / "bench.json");
    EXPECT_EQ(Json::parse(bytes.begin(), bytes.end())["lights"].size(), 2u);
    const ProcessResult info = runEdgeshade({"info", file});
    EXPECT_NE(info.out.find("light 1"), std::string::npos) << info.out;
    EXPECT_NE(info.out.find("spot"), std::string::npos) << info.out;
}

} // namespace edgeshade::test
