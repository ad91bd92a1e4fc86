// Files of ../shared/cases that once gave wrong results; the expected results come from others.
#include "tests/cli/message.hpp"
#include "tests/support/gltf_builder.hpp"
#include "tests/support/run_edgeshade.hpp"
#include "tests/support/temp_folder.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

class SharedCases : public testing::Test {
  protected:
    void SetUp() override {
        if (!std::filesystem::is_directory(EDGESHADE_SHARED_CASES))
            GTEST_SKIP() << EDGESHADE_SHARED_CASES << " is not there, so no case of it is drawn";
    }

    static std::string caseOf(const std::string& name) {
        return std::string(EDGESHADE_SHARED_CASES) + "/" + name + ".gltf";
    }
    ProcessResult render(const std::string& file, const std::vector<std::string>& more) {
        std::vector<std::string> arguments = {
            "render",  file,       folder_ / "out.png",    "--size",
            "480x270", "--report", folder_ / "report.json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return runEdgeshade(arguments);
    }
    Bytes picture(const std::string& file, const std::vector<std::string>& more = {}) {
        const ProcessResult result = render(file, more);
        EXPECT_EQ(result.status, 0) << result.err;
        return readFile(folder_ / "out.png");
    }
    Json report() const {
        const Bytes bytes = readFile(folder_ / "report.json");
        return Json::parse(bytes.begin(), bytes.end());
    }
    static std::string warningsOfInfo(const std::string& file) {
        const ProcessResult result = runEdgeshade({"info", file});
        EXPECT_EQ(result.status, 0) << result.err;
        return warningsOf(result);
    }

    TempFolder folder_;
};

} // namespace

TEST_F(SharedCases, WhatPopsInIsThere) {
    const std::string folder = "rest-scale-zero/";
    const std::string grows = caseOf(folder + "r04-rest-scale-zero-grows");
    const Bytes expected = picture(caseOf(folder + "expected-of-r04-at-1s"));
    EXPECT_EQ(picture(grows, {"--time", "1"}), expected);
    EXPECT_NE(picture(grows), expected);
    for (const char* name : {"r04b-child-of-zero-scaled-parent", "r04e-flat-scale-grows"})
        EXPECT_NE(picture(caseOf(folder + name), {"--time", "1"}), picture(caseOf(folder + name)))
            << name;
}

TEST_F(SharedCases, VerticesWithoutWeightsGoWithTheFirstJoint) {
    const std::string folder = "zero-weight-vertices/";
    EXPECT_EQ(picture(caseOf(folder + "r61-zero-weights-in-a-scaled-armature")),
              picture(caseOf(folder + "expected-of-r61")));
}

TEST_F(SharedCases, SkinsAreTurnedOverByTheirNodes) {
    const std::string folder = "skin-turned-over/";
    const std::string file = caseOf(folder + "r33g-armature-animated-into-mirror");
    EXPECT_EQ(picture(file, {"--time", "1"}), picture(caseOf(folder + "expected-of-r33g-at-1s")));
}

TEST_F(SharedCases, LightsOfRange0AreThere) {
    const std::string folder = "light-range-zero/";
    EXPECT_EQ(picture(caseOf(folder + "r62-directional-light-range-zero")),
              picture(caseOf(folder + "expected-of-r62")));
    const ProcessResult result = render(caseOf(folder + "r28-light-range-zero"), {});
    EXPECT_NE(warningsOf(result).find("range is 0"), std::string::npos) << result.err;
    EXPECT_EQ(report()["lights"][0]["position"], (Json{1.0, 3.0, 1.0, 1.0}));
    EXPECT_FALSE(report()["lights"][0].contains("range"));
}

TEST_F(SharedCases, ALightOfAFlatNodeHasItsDirection) {
    picture(caseOf("light-of-a-flat-node/r11c-directional-light-flat-y-node"));
    const Json towards = report()["lights"].at(0)["position"];
    EXPECT_NEAR(towards[1].get<double>(), 0.766, 1e-3);
    EXPECT_NEAR(towards[2].get<double>(), 0.643, 1e-3);
    EXPECT_EQ(towards[3], 0.0);
}

TEST_F(SharedCases, WhatOfAnAnimationIsSoundIsPlayed) {
    const std::string folder = "animation-of-one-bad-sampler/";
    const std::string name = folder + "r64-animation-first-bad-second-good";
    const Bytes text = readFile(caseOf(name));
    Json still = Json::parse(text.begin(), text.end());
    still.erase("animations");
    still["nodes"][0]["rotation"] = {0.0, std::sqrt(0.5f), 0.0, std::sqrt(0.5f)};
    still["nodes"][0]["translation"] = {2, 0, 0}; // of two keyframes at 1 s the later one continues
    const std::string turned = folder_.write("turned.gltf", std::string_view(still.dump()));
    const std::vector<std::string> camera = {"--camera-from", "4,5,7", "--camera-to", "0,0.5,0"};
    const Bytes expected = picture(turned, camera);
    EXPECT_EQ(picture(caseOf(name), {"--time", "2", camera[0], camera[1], camera[2], camera[3]}),
              expected);
    const ProcessResult result = render(caseOf(name), {"--time", "2"});
    EXPECT_NE(warningsOf(result).find("animations[0].samplers[0].input"), std::string::npos)
        << result.err;
    for (const char* each : {"r26-negative-key-times", "r27-equal-key-times",
                             "r43-matrix-node-animated", "r64-animation-first-bad-second-good"}) {
        const std::string warnings = warningsOfInfo(caseOf(folder + each));
        EXPECT_NE(warnings.find("animations[0]"), std::string::npos) << each << ": " << warnings;
    }
}

TEST_F(SharedCases, BackslashesPartNames) {
    picture(caseOf("backslash-uri/r63-backslash-buffer"));
    EXPECT_EQ(report()["warnings"], Json::array());
}

TEST_F(SharedCases, TheDefaultCameraKeepsItsDistance) {
    for (const char* name : {"f05-needle-towards-the-eye", "f06-triangle-towards-the-eye"}) {
        picture(caseOf(std::string("eye-on-a-vertex/") + name));
        EXPECT_GT(report()["camera"]["near"].get<double>(), 0.03) << name;
    }
}

} // namespace edgeshade::test
