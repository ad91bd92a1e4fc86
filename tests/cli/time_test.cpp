// --time: nodes, cameras and lights in the pose of the file's animation.
#include "tests/support/gltf_builder.hpp"
#include "tests/support/run_edgeshade.hpp"
#include "tests/support/temp_folder.hpp"

#include <gtest/gtest.h>
#include <utility>

namespace edgeshade::test {
namespace {

const std::vector<std::string> camera = {"--camera-from", "4,5,7", "--camera-to", "0,0.5,0"};

/// A floor with two boxes and an arm that rotates and moves for 4 seconds. From the arm hangs a
/// spot that shines down past a smaller box on the same arm. The arm starts beside the boxes and
/// ends with the spot inside one of them; a third box shrinks to nothing in the last second.
std::string lampOnAnArm(const TempFolder& folder) {
    const std::string lights = "KHR_lights_punctual";
    const float sine = std::sin(0.6f), cosine = std::cos(0.6f);
    GltfBuilder gltf;
    gltf.addShapeNode(box(glm::vec3(6.0f, 0.2f, 6.0f)));
    gltf.addNode({{"mesh", gltf.addShape(box(glm::vec3(0.8f)))}, {"translation", {0, 0.6, 0}}});
    gltf.addNode({{"mesh", gltf.addShape(box(glm::vec3(1.0f)))}, {"translation", {2, 3, 0}}});
    gltf.useExtension(lights);
    gltf.json["extensions"][lights]["lights"] = {
        {{"type", "spot"},
         {"intensity", 60},
         {"spot", {{"innerConeAngle", 0.3}, {"outerConeAngle", 0.7}}}}};
    gltf.json["cameras"] = {
        {{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}}}}};
    const float half = std::sqrt(0.5f);
    const int lamp = gltf.addNode({{"rotation", {-half, 0, 0, half}}, // down
                                   {"camera", 0},
                                   {"extensions", {{lights, {{"light", 0}}}}}},
                                  false);
    const int shade = gltf.addNode(
        {{"mesh", gltf.addShape(box(glm::vec3(0.3f)))}, {"translation", {0.1, -0.8, 0}}}, false);
    const int arm = gltf.addNode({{"translation", {-2, 3, 0}}, {"children", {lamp, shade}}});
    const int shrinking = gltf.addNode(
        {{"mesh", gltf.addShape(box(glm::vec3(0.7f)))}, {"translation", {-1, 0.5, 1}}});
    const int times = gltf.addArray<float>({0, 2, 4}, 1, {{"min", {0.0}}, {"max", {4.0}}});
    const int moves = gltf.addArray<float>({-2, 3, 0, 0.3f, 3, 0, 2, 3, 0}, 3);
    const int turns = gltf.addArray<float>({0, 0, 0, 1, 0, 0, sine, cosine, 0, 0, 0, 1}, 4);
    const int scales = gltf.addArray<float>({1, 1, 1, 1, 1, 1, 0, 0, 0}, 3);
    const auto channel = [](int sampler, int node, const char* path) {
        return Json({{"sampler", sampler}, {"target", {{"node", node}, {"path", path}}}});
    };
    gltf.json["animations"] = {{{"channels",
                                 {channel(0, arm, "translation"), channel(1, arm, "rotation"),
                                  channel(2, shrinking, "scale")}},
                                {"samplers",
                                 {{{"input", times}, {"output", moves}},
                                  {{"input", times}, {"output", turns}},
                                  {{"input", times}, {"output", scales}}}}}};
    return folder.write("arm.glb", gltf.glb());
}

/// A floor and, if `all`, a box with a child and a skinned tetrahedron above it. Within a second an
/// animation scales the box from `scale`, its rest scale, and the joint from nothing, to 1.
std::string growing(const TempFolder& folder, const Json& scale, bool all) {
    GltfBuilder gltf;
    gltf.addShapeNode(box(glm::vec3(3.0f, 0.2f, 3.0f)));
    if (!all) return folder.write("floor.glb", gltf.glb());
    const int child = gltf.addNode(
        {{"mesh", gltf.addShape(box(glm::vec3(0.3f)))}, {"translation", {1, 1, 0}}}, false);
    const int joint = gltf.addNode(Json::object(), false);
    gltf.json["skins"] = {{{"joints", Json::array({joint})}}};
    Json skinned = gltf.primitiveOf(tetrahedron());
    skinned["attributes"]["JOINTS_0"] = gltf.addArray(std::vector<std::uint8_t>(16, 0), 4);
    skinned["attributes"]["WEIGHTS_0"] = gltf.addArray(std::vector<float>(16, 0.25f), 4);
    const int mesh = gltf.addNode({{"mesh", gltf.addMesh(skinned)}, {"skin", 0}}, false);
    const int top = gltf.addNode({{"mesh", gltf.addShape(box(glm::vec3(0.5f)))},
                                  {"translation", {0, 1, 0}},
                                  {"children", {child}},
                                  {"scale", scale}});
    const int bones = gltf.addNode(
        {{"children", {joint, mesh}}, {"translation", {-1, 0.5, 1}}, {"scale", {0, 0, 0}}});
    const int times = gltf.addArray<float>({0, 1}, 1, {{"min", {0.0}}, {"max", {1.0}}});
    const std::vector<float> scales = {scale[0], scale[1], scale[2], 1, 1, 1};
    const int ofTop = gltf.addArray(scales, 3),
              ofBones = gltf.addArray<float>({0, 0, 0, 1, 1, 1}, 3);
    const auto channel = [](int sampler, int node) {
        return Json({{"sampler", sampler}, {"target", {{"node", node}, {"path", "scale"}}}});
    };
    gltf.json["animations"] = {
        {{"channels", {channel(0, top), channel(1, bones)}},
         {"samplers",
          {{{"input", times}, {"output", ofTop}}, {{"input", times}, {"output", ofBones}}}}}};
    return folder.write("growing.glb", gltf.glb());
}

std::vector<std::string> atTime(const std::string& seconds, std::vector<std::string> words) {
    words.insert(words.end(), {"--time", seconds});
    return words;
}

class Time : public testing::Test {
  protected:
    ProcessResult run(const std::string& verb, std::vector<std::string> more) {
        std::vector<std::string> arguments = {verb, file_};
        if (verb == "render") arguments.push_back(folder_ / "out.png");
        more.insert(more.end(), {"--size", "160x120", "--report", folder_ / "report.json"});
        arguments.insert(arguments.end(), more.begin(), more.end());
        return runEdgeshade(arguments);
    }
    Bytes picture(std::vector<std::string> more) {
        more.insert(more.end(), camera.begin(), camera.end());
        const ProcessResult result = run("render", more);
        EXPECT_EQ(result.status, 0) << result.err;
        return readFile(folder_ / "out.png");
    }
    Json report() const {
        const Bytes bytes = readFile(folder_ / "report.json");
        return Json::parse(bytes.begin(), bytes.end());
    }

    void expectNothingIsDrawn(const Json& scale, const std::vector<std::string>& method);

    TempFolder folder_;
    std::string file_ = lampOnAnArm(folder_);
};

using LongTime = Time;

} // namespace

TEST_F(Time, PlacesNodesLightsAndCameras) {
    const Bytes start = picture({"--time", "0"});
    EXPECT_EQ(start, picture({})) << "the arm starts where it is at rest";
    EXPECT_FALSE(report()["settings"].contains("time"));
    const Bytes half = picture({"--time", "2"});
    EXPECT_NE(half, start);
    EXPECT_EQ(report()["settings"]["time"], 2.0);
    const Json light = report()["lights"][0];
    EXPECT_NEAR(light["position"][0].get<double>(), 0.3, 1e-6);
    EXPECT_NEAR(light["cone"]["axis"][0].get<double>(), std::sin(1.2), 1e-6);
    EXPECT_EQ(picture({"--time", "4"}), picture({"--time", "1e9"})) << "it ends";

    ASSERT_EQ(run("render", {"--time", "2", "--camera", "0"}).status, 0);
    const Json viewFromWorld = report()["camera"]["matrix"];
    for (std::size_t row = 0; row < 3; ++row) // the lamp's place, (0.3, 3, 0), is the eye's
        EXPECT_NEAR(0.3 * viewFromWorld[row].get<double>() +
                        3.0 * viewFromWorld[4 + row].get<double>() +
                        viewFromWorld[12 + row].get<double>(),
                    0.0, 1e-6);
    const Bytes fromLamp = readFile(folder_ / "out.png");
    ASSERT_EQ(run("render", {"--time", "1", "--camera", "0"}).status, 0);
    EXPECT_NE(readFile(folder_ / "out.png"), fromLamp);
}

TEST_F(Time, MasksAreThoseOfRays) {
    for (const std::string time : {"0", "1.3", "3.1"})
        for (const std::string shadows : {"volumes", "primitive-map"}) {
            const ProcessResult result =
                run("compare", {"--time", time, "--views", "4", "--shadows", shadows, "--lights",
                                "file", "--ground", "#808080"});
            ASSERT_EQ(result.status, 0) << result.err;
            const Json found = report();
            EXPECT_EQ(found["wrong_image_beyond_1px_not_tied"], 0) << time << " s, " << shadows;
            EXPECT_LT(found["wrong_mask_pixels"].get<int>(), 20) << time << " s, " << shadows;
        }
}

/// Pictures by `method` of a file with and without a part scaled to nothing are the same.
void Time::expectNothingIsDrawn(const Json& scale, const std::vector<std::string>& method) {
    SCOPED_TRACE(method[1] + " " + scale.dump());
    file_ = growing(folder_, scale, false);
    const Bytes expected = picture(method);
    file_ = growing(folder_, scale, true);
    EXPECT_EQ(picture(method), expected);
    EXPECT_EQ(picture(atTime("0", method)), expected);
    EXPECT_NE(picture(atTime("1", method)), expected);
}

TEST_F(Time, WhatIsScaledToNothingNeitherShowsNorCasts) {
    expectNothingIsDrawn({0, 0, 0}, {"--shadows", "volumes"});
    expectNothingIsDrawn({1, 0, 1}, {"--shadows", "primitive-map"});
    expectNothingIsDrawn({0, 1, 1}, {"--layout", "published"});
    const ProcessResult result =
        run("compare", {"--time", "0.6", "--views", "4", "--sun", "1,2,1"});
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(report()["wrong_image_beyond_1px_not_tied"], 0);
}

TEST_F(LongTime, WhatIsScaledToNothingNeitherShowsNorCastsByAnyMethod) {
    for (const Json& scale : {Json{0, 0, 0}, Json{1, 0, 1}, Json{0, 1, 1}})
        for (const std::vector<std::string>& method :
             {std::vector<std::string>{"--shadows", "volumes"},
              {"--shadows", "primitive-map"},
              {"--shadows", "irregular-z-buffer"},
              {"--shadows", "map"},
              {"--layout", "published"},
              {"--layout", "brute-force"}})
            expectNothingIsDrawn(scale, method);
}

TEST_F(Time, BenchTakesItToo) {
    ASSERT_EQ(run("bench", {"--time", "2", "--frames", "2"}).status, 0);
    EXPECT_EQ(report()["settings"]["time"], 2.0);
}

TEST_F(Time, WithoutAnAnimationItWarns) {
    GltfBuilder gltf;
    gltf.addShapeNode(box(glm::vec3(1.0f)));
    file_ = folder_.write("still.glb", gltf.glb());
    const ProcessResult result = run("render", {"--time", "1"});
    EXPECT_EQ(result.status, 0);
    EXPECT_NE(result.err.find("--time: the scene has no animation"), std::string::npos)
        << result.err;
}

TEST_F(Time, RefusesWhatIsNoTime) {
    for (const std::string text : {"-1", "nan", "inf", "2e9", "1s", ""}) {
        const ProcessResult result = run("render", {"--time=" + text});
        EXPECT_EQ(result.status, 1) << text;
        EXPECT_NE(result.err.find("--time"), std::string::npos) << result.err;
    }
}

} // namespace edgeshade::test
