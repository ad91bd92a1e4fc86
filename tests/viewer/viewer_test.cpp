// The viewer against single pictures of the same views.

#include "preprocess/base/error.hpp"
#include "preprocess/gltf/gltf_reading.hpp"
#include "preprocess/reading/animation_reading.hpp"
#include "preprocess/reading/flatten.hpp"
#include "src/gl/headless_context.hpp"
#include "src/rivals/rivals.hpp"
#include "src/settings/settings.hpp"
#include "src/viewer/viewer.hpp"
#include "tests/support/gltf_builder.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/loaded_scene.hpp"
#include "tests/support/moving_scenes.hpp"
#include "tests/support/scene_builder.hpp"

#include <gtest/gtest.h>

namespace edgeshade::viewer {
namespace {

using Json = nlohmann::ordered_json;
using Pixels = std::vector<std::uint8_t>;

constexpr int width = 160;
constexpr int height = 120;

/// Settings that include all rival methods.
ViewerSettings withRivals() {
    ViewerSettings settings;
    settings.render.rivals = &allRivals();
    return settings;
}

/// A viewer with the yard in its own context, without handles.
class ViewerTest : public testing::Test {
  protected:
    ViewerTest() {
        viewer.resize(width, height, 1.0);
        viewer.show(test::loadedOf(test::yard().scene()));
        viewer.change({{"show_lights", false}});
        viewer.change(Json::parse(R"({"lights": [[1.5, 6, 2, 1], [-0.3, 1, 0.4, 0]]})"));
    }

    Pixels picture() {
        EXPECT_TRUE(viewer.frame(0.0));
        return context.readPixels();
    }

    /// The same view drawn by `render`.
    Pixels plainPicture(const SideSettings& side) const {
        RenderSettings settings;
        setSide(settings, side);
        const ViewState& state = viewer.state();
        settings.shading = state.shading;
        settings.ambient = state.ambient;
        return test::drawScene(test::yard().scene(), {state.camera, state.lights, width, height},
                               settings);
    }

    gl::HeadlessContext context{test::testPicture(width, height)};
    Viewer viewer{context.capabilities(), withRivals()};
};

/// The columns [from, to) of a picture.
Pixels columns(const Pixels& pixels, int from, int to) {
    Pixels result;
    for (int y = 0; y < height; ++y)
        result.insert(result.end(), pixels.begin() + 4 * (y * width + from),
                      pixels.begin() + 4 * (y * width + to));
    return result;
}

std::size_t differing(const Pixels& a, const Pixels& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); i += 4)
        count += !std::equal(a.begin() + static_cast<long>(i), a.begin() + static_cast<long>(i) + 4,
                             b.begin() + static_cast<long>(i));
    return count;
}

// The comparison picture is drawn last: its context replaces the viewer's.

TEST_F(ViewerTest, DrawsThePictureOfRender) {
    const Pixels drawn = picture();
    EXPECT_TRUE(drawn == plainPicture(viewer.state().left));
}

TEST_F(ViewerTest, ASunByPlaceAndTimeIsTheLightFromThere) {
    viewer.change(Json::parse(R"({"lights": [[0, 1, 0, 0]], "sun": {"place": [48.14, 11.57],
        "time": "2026-06-21T09:00+02:00", "north": 40}})"));
    EXPECT_EQ(viewer.state().lights.size(), 1u);
    EXPECT_EQ(viewer.sun()["up"], true);
    const Pixels drawn = picture();
    viewer.change(Json::parse(R"({"sun": {"time": "2026-06-21T01:00+02:00"}})"));
    const Pixels night = picture();
    EXPECT_FALSE(night == drawn);
    EXPECT_EQ(viewer.sun()["up"], false);
    // Nothing is lit, whatever shadows there would be.
    viewer.change(Json::parse(R"({"left": {"shadows": "none"}})"));
    EXPECT_TRUE(picture() == night);
    // The sun's path and the horizon.
    viewer.change(Json::parse(R"({"show_lights": true})"));
    EXPECT_FALSE(picture() == night);
    viewer.change(Json::parse(R"({"sun": {"time": "2026-06-21T09:00+02:00"}})"));
    EXPECT_TRUE(drawn == plainPicture({ShadowMethod::automatic}));
}

TEST_F(ViewerTest, ADayPlaysUntilSomebodyMovesItsSun) {
    EXPECT_TRUE(viewer.sun().is_null());
    viewer.change(Json::parse(R"({"day_playing": true, "sun": {"place": [48.14, 11.57],
        "time": "2026-06-21T09:00+02:00"}})"));
    EXPECT_TRUE(viewer.frame(1.0));
    EXPECT_TRUE(viewer.wantsFrame());
    EXPECT_TRUE(viewer.frame(2.0));
    EXPECT_EQ(sun::textOf(viewer.state().sun->time), "2026-06-21T10:00+02:00");
    viewer.change(Json::parse(R"({"lights": [[0.3, 1, 0, 0]]})"));
    EXPECT_FALSE(viewer.state().sun);
    EXPECT_FALSE(viewer.state().dayPlays);
    EXPECT_EQ(viewer.state().lights[0].position, glm::dvec4(0.3, 1, 0, 0));
}

TEST_F(ViewerTest, DrawsMapsToo) {
    viewer.change(Json::parse(R"({"left": {"shadows": "map", "map_size": 256}})"));
    const Pixels drawn = picture();
    EXPECT_TRUE(drawn == plainPicture(viewer.state().left));
}

TEST_F(ViewerTest, DrawsOtherKindsOfMapsSideBySide) {
    viewer.change(Json::parse(R"({"split": true, "split_at": 0.5, "lights": [[0.3, 1, 0.2, 0]],
        "left": {"shadows": "map", "map_size": 128, "map_kind": "cascades", "cascades": 2},
        "right": {"shadows": "map", "map_size": 128, "filter": "vsm", "pcf": 5}})"));
    const Pixels drawn = picture();
    const Pixels left = plainPicture(viewer.state().left);
    const Pixels right = plainPicture(viewer.state().right);
    EXPECT_TRUE(columns(drawn, 0, width / 2 - 2) == columns(left, 0, width / 2 - 2));
    EXPECT_TRUE(columns(drawn, width / 2 + 2, width) == columns(right, width / 2 + 2, width));
    EXPECT_GT(differing(left, right), 0u);
    EXPECT_EQ(viewer::toJson(viewer.state())["right"]["filter"], "vsm");
}

TEST_F(ViewerTest, DrawsBothWarpsSideBySide) {
    viewer.change(Json::parse(R"({"split": true, "split_at": 0.5, "lights": [[0.3, 1, 0.2, 0]],
        "left": {"shadows": "map", "map_size": 64, "map_kind": "warped"},
        "right": {"shadows": "map", "map_size": 64, "map_kind": "warped",
                  "warp": "non-orthogonal", "filter": "msm", "pcf": 3}})"));
    const Pixels drawn = picture();
    const Pixels left = plainPicture(viewer.state().left);
    const Pixels right = plainPicture(viewer.state().right);
    EXPECT_TRUE(columns(drawn, 0, width / 2 - 2) == columns(left, 0, width / 2 - 2));
    EXPECT_TRUE(columns(drawn, width / 2 + 2, width) == columns(right, width / 2 + 2, width));
    EXPECT_GT(differing(left, right), 0u);
    EXPECT_EQ(viewer::toJson(viewer.state())["right"]["warp"], "non-orthogonal");
}

TEST_F(ViewerTest, BothSidesOfASplitAreTheirWholePictures) {
    viewer.change(Json::parse(R"({"split": true, "split_at": 0.4, "right": {"map_size": 64}})"));
    const Pixels drawn = picture();
    const Pixels left = plainPicture(viewer.state().left);
    const Pixels right = plainPicture(viewer.state().right);
    // Column 64 is the first of the right side; the line between them is 4 wide.
    EXPECT_TRUE(columns(drawn, 0, 62) == columns(left, 0, 62));
    EXPECT_TRUE(columns(drawn, 66, width) == columns(right, 66, width));
    EXPECT_GT(differing(left, right), 0u);
}

TEST_F(ViewerTest, ASplitOfMapsOnTheLeftIsNotCutEither) {
    viewer.change(Json::parse(R"({"split": true, "split_at": 0.6,
        "left": {"shadows": "map", "map_size": 128}, "right": {"shadows": "volumes"}})"));
    const Pixels drawn = picture();
    const Pixels left = plainPicture(viewer.state().left);
    const Pixels right = plainPicture(viewer.state().right);
    EXPECT_TRUE(columns(drawn, 0, 94) == columns(left, 0, 94));
    EXPECT_TRUE(columns(drawn, 98, width) == columns(right, 98, width));
}

TEST_F(ViewerTest, DrawsOnlyWhenSomethingChanged) {
    EXPECT_TRUE(viewer.wantsFrame());
    EXPECT_TRUE(viewer.frame(0.0));
    EXPECT_FALSE(viewer.wantsFrame());
    EXPECT_FALSE(viewer.frame(1.0));
    viewer.pointerMove(Pointer()); // of a pointer that isn't down
    EXPECT_FALSE(viewer.wantsFrame());
    viewer.run(Command::orbitLeft);
    EXPECT_TRUE(viewer.wantsFrame());
    EXPECT_TRUE(viewer.frame(2.0));
    viewer.invalidate();
    EXPECT_TRUE(viewer.frame(3.0));
}

TEST_F(ViewerTest, RefusedChangesChangeNothing) {
    viewer.frame(0.0);
    const Json before = toJson(viewer.state());
    EXPECT_THROW(viewer.change({{"ambient", 0.1}, {"speed", 1000}}), Error);
    EXPECT_EQ(toJson(viewer.state()), before);
    EXPECT_FALSE(viewer.wantsFrame());
}

TEST_F(ViewerTest, HandlesAreDrawnOverThePicture) {
    const Pixels without = picture();
    viewer.change({{"show_lights", true}});
    EXPECT_GT(differing(picture(), without), 100u);
    viewer.change({{"show_lights", false}});
    EXPECT_TRUE(picture() == without);
}

TEST_F(ViewerTest, TheTintOfVolumesLeavesOpaqueAlphaAndGoesAgain) {
    const Pixels without = picture();
    viewer.change({{"debug", "volumes"}});
    const Pixels tinted = picture();
    EXPECT_GT(differing(tinted, without), 100u);
    for (std::size_t i = 3; i < tinted.size(); i += 4)
        ASSERT_EQ(tinted[i], 255);
    viewer.change({{"debug", "none"}});
    EXPECT_TRUE(picture() == without);
}

TEST_F(ViewerTest, ALightDraggedByItsHandleShadesFromThere) {
    viewer.change(Json::parse(R"({"show_lights": true, "lights": [[1.5, 4, 2, 1]],
        "camera": {"from": [0, 6, 12], "to": [0, 1, 0]}})"));
    const Pixels before = picture();
    Pointer pointer;
    // Position of a handle: the wheel and a drag agree on it.
    const glm::dvec4 clip =
        clipFromView(frustumOf(viewer.state().camera, static_cast<double>(width) / height), 0.1) *
        viewFromWorld(viewer.state().camera) * viewer.state().lights[0].position;
    pointer.x = 0.5 * width * (1 + clip.x / clip.w);
    pointer.y = 0.5 * height * (1 - clip.y / clip.w);
    viewer.pointerDown(pointer);
    pointer.x -= 40;
    viewer.pointerMove(pointer);
    viewer.pointerUp(pointer);
    EXPECT_LT(viewer.state().lights[0].position.x, 0.0);
    EXPECT_NEAR(viewer.state().lights[0].position.y, 4.0, 1e-9);
    EXPECT_GT(differing(picture(), before), 200u);
}

TEST_F(ViewerTest, MasksOfLowerResolutionAreCountedAndGivenBack) {
    if (!test::hasDerivatives()) GTEST_SKIP() << "without derivatives there is no coarse mask";
    const auto exact = picture();
    const std::size_t bytes = viewer.stats().shadowBytes;
    viewer.change(Json::parse(R"({"left": {"mask_scale": 4}})"));
    const auto coarse = picture();
    EXPECT_GT(viewer.stats().shadowBytes, bytes);
    EXPECT_GT(differing(coarse, exact), 0u);
    const SideSettings coarseSide = viewer.state().left;
    viewer.change(Json::parse(R"({"split": true, "split_at": 0.5, "right": {"shadows": "auto"}})"));
    const auto both = picture();
    EXPECT_EQ(differing(columns(both, 0, 75), columns(coarse, 0, 75)), 0u);
    EXPECT_EQ(differing(columns(both, 85, width), columns(exact, 85, width)), 0u);
    viewer.change(Json::parse(R"({"split": false, "left": {"mask_scale": 1}})"));
    EXPECT_EQ(differing(picture(), exact), 0u);
    EXPECT_EQ(viewer.stats().shadowBytes, bytes);
    EXPECT_EQ(differing(coarse, plainPicture(coarseSide)), 0u);
}

TEST_F(ViewerTest, StatisticsTellOfTheScene) {
    viewer.frame(0.0);
    const FrameStats stats = viewer.stats();
    EXPECT_EQ(stats.triangles, test::yard().scene().triangleCount());
    EXPECT_GT(stats.edges, stats.silhouettes);
    EXPECT_GT(stats.records, 0u);
    EXPECT_LT(stats.records, stats.edges); // flat edges have no records
    EXPECT_GT(stats.silhouettes, 0u);
    EXPECT_GT(stats.shadowBytes, 0u);
    EXPECT_EQ(stats.mapBytes, 0u);
    EXPECT_GT(stats.frameMs, 0.0);
    EXPECT_FALSE(stats.stageMs);
    viewer.change(Json::parse(R"({"left": {"shadows": "map", "map_size": 64}})"));
    viewer.frame(1.0);
    EXPECT_GT(viewer.stats().mapBytes, 0u);
    viewer.change(Json::parse(R"({"left": {"shadows": "volumes"}})"));
    viewer.frame(2.0);
    const auto stages = viewer.stats().stageMs;
    ASSERT_TRUE(stages);
    EXPECT_GT(stages->ambient, 0.0);
    EXPECT_GT(stages->silhouette, 0.0);
    EXPECT_GT(stages->lit, 0.0);
    EXPECT_EQ(toJson(viewer.stats())["stage_ms"]["lit"], stages->lit);
}

TEST(ViewerWithoutAScene, DrawsTheGroundAndTakesEverything) {
    const gl::HeadlessContext context(test::testPicture(width, height));
    Viewer viewer(context.capabilities());
    viewer.resize(width, height, 1.0);
    for (int c = 0; c <= static_cast<int>(Command::faster); ++c)
        viewer.run(static_cast<Command>(c));
    viewer.pointerDown(Pointer());
    viewer.wheel(10, 10, 1);
    EXPECT_FALSE(viewer.hasScene());
    EXPECT_EQ(viewer.stats().triangles, 0u);
    EXPECT_TRUE(viewer.frame(0.0));
    EXPECT_NE(context.readPixels(), Pixels(4 * width * height, 0));
}

TEST_F(ViewerTest, AGroundIsLaidBeneathAFloorWhereAskedAlone) {
    EXPECT_FALSE(viewer.state().ground) << "the yard has a floor";
    const Pixels without = picture();
    viewer.run(Command::toggleGround);
    ASSERT_TRUE(viewer.state().ground);
    picture();
    viewer.change({{"ground", "#ff0000"}});
    const Pixels red = picture();
    EXPECT_GT(differing(red, without), 500u);
    viewer.change({{"ground", "off"}});
    EXPECT_EQ(picture(), without);
}

TEST_F(ViewerTest, WhereThereIsNoFloorShadowsAreCaught) {
    const Scene scene = test::SceneBuilder().box({-1, 0, -1}, {1, 3, 1}).scene();
    viewer.show({{}, scene, {}, buildPlanePairs(scene, false), {}, {}});
    viewer.change(Json::parse(R"({"show_lights": false, "lights": [[-1, 1, 0.3, 0]]})"));
    ASSERT_TRUE(viewer.state().ground);
    EXPECT_EQ(viewer.stats().triangles, 12u);
    const Pixels caught = picture();
    viewer.change({{"ground", "off"}});
    EXPECT_GT(differing(caught, picture()), 100u);
}

TEST(ViewerAfterALostContext, DrawsTheSameInANewOne) {
    Pixels before;
    auto context = std::make_unique<gl::HeadlessContext>(test::testPicture(width, height));
    Viewer viewer(context->capabilities(), withRivals());
    viewer.resize(width, height, 1.0);
    viewer.show(test::loadedOf(test::yard().scene()));
    viewer.frame(0.0);
    before = context->readPixels();
    viewer.forgetGpu();
    viewer.run(Command::orbitLeft);
    viewer.run(Command::orbitRight);
    EXPECT_FALSE(viewer.wantsFrame());
    EXPECT_FALSE(viewer.frame(1.0));
    context.reset();
    context = std::make_unique<gl::HeadlessContext>(test::testPicture(width, height));
    viewer.restoreGpu(context->capabilities());
    EXPECT_TRUE(viewer.frame(2.0));
    EXPECT_LT(differing(context->readPixels(), before), 20u); // the eye came back except for
                                                              // rounding
    viewer.forgetGpu();
}

LoadedScene loaded(const test::GltfBuilder& gltf) {
    LoadedScene made;
    made.document = std::make_shared<const GltfDocument>(parseGltf(gltf.glb(), "moving.glb"));
    made.scene = flattenScene(*made.document, 0.0);
    made.planePairs = buildPlanePairs(made.scene, false);
    return made;
}

/// A slab, and a box above it whose `path` goes from one value to another within a second.
LoadedScene movingScene(const std::string& path, const std::vector<float>& values) {
    test::GltfBuilder gltf;
    gltf.addShapeNode(test::box(glm::vec3(3.0f, 0.2f, 3.0f)));
    const int animatedNode = gltf.addNode({{"mesh", gltf.addShape(test::box(glm::vec3(0.8f)))}});
    const int times = gltf.addArray<float>({0.0f, 1.0f}, 1, {{"min", {0.0}}, {"max", {1.0}}});
    gltf.json["animations"] = {
        {{"channels", {{{"sampler", 0}, {"target", {{"node", animatedNode}, {"path", path}}}}}},
         {"samplers", {{{"input", times}, {"output", gltf.addArray(values, 3)}}}}}};
    return loaded(gltf);
}

/// A slab and a box on it, and above them two lamps, the second 1 to the right, and a camera, which
/// move from x = -1 to x = 1 within a second.
LoadedScene movingLamps() {
    const std::string lights = "KHR_lights_punctual";
    test::GltfBuilder gltf;
    gltf.addShapeNode(test::box(glm::vec3(3.0f, 0.2f, 3.0f)));
    gltf.addNode(
        {{"mesh", gltf.addShape(test::box(glm::vec3(0.8f)))}, {"translation", {0, 0.5, 0}}});
    gltf.useExtension(lights);
    gltf.json["extensions"][lights]["lights"] = {{{"type", "point"}, {"intensity", 30}}};
    gltf.json["cameras"] = {{{"type", "perspective"},
                             {"name", "eye"},
                             {"perspective", {{"yfov", 1.0}, {"znear", 0.1}}}}};
    const nlohmann::ordered_json lamp = {{lights, {{"light", 0}}}};
    const int second = gltf.addNode({{"translation", {1, 0, 0}}, {"extensions", lamp}}, false);
    const int arm = gltf.addNode(
        {{"translation", {-1, 2, 0}}, {"children", {second}}, {"camera", 0}, {"extensions", lamp}});
    const int times = gltf.addArray<float>({0.0f, 1.0f}, 1, {{"min", {0.0}}, {"max", {1.0}}});
    const int values = gltf.addArray<float>({-1, 2, 0, 1, 2, 0}, 3);
    gltf.json["animations"] = {
        {{"channels", {{{"sampler", 0}, {"target", {{"node", arm}, {"path", "translation"}}}}}},
         {"samplers", {{{"input", times}, {"output", values}}}}}};
    return loaded(gltf);
}

class Animated : public ViewerTest {
  protected:
    void show(const std::string& path, const std::vector<float>& values) {
        viewer.show(movingScene(path, values));
        viewer.change({{"show_lights", false}, {"ground", "off"}});
    }
    Pixels plain(const Scene& scene) const {
        const ViewState& state = viewer.state();
        RenderSettings settings;
        settings.shading = state.shading;
        settings.ambient = state.ambient;
        return test::drawScene(scene, {state.camera, state.lights, width, height}, settings);
    }
};

TEST_F(Animated, ABatchIsWhereItsNodeIsAndSoIsItsShadow) {
    show("translation", {0, 1, 0, 2, 1, 0});
    EXPECT_EQ(viewer.animationSeconds(), 1.0);
    viewer.change({{"time", 0.5}});
    const Pixels half = picture();
    viewer.change({{"time", 0.0}});
    EXPECT_GT(differing(half, picture()), 100u);
    LoadedScene there = movingScene("translation", {1, 1, 0, 1, 1, 0});
    Warnings none;
    place(there.scene, poseAt(readAnimation(*there.document, none).value(), there.scene, 0.0));
    EXPECT_EQ(differing(half, plain(there.scene)), 0u);
}

TEST_F(Animated, WhatIsScaledToNothingIsNotDrawnAndHasNoShadow) {
    show("scale", {1, 1, 1, 0, 0, 0});
    viewer.change({{"time", 1.0}});
    const Pixels gone = picture();
    LoadedScene slab = movingScene("scale", {1, 1, 1, 0, 0, 0});
    std::erase_if(slab.scene.batches, [](const Batch& batch) { return batch.isAnimated(); });
    EXPECT_EQ(differing(gone, plain(slab.scene)), 0u);
}

/// Viewers of deforming scenes.
class Deforming : public Animated {
  protected:
    void show(const test::GltfBuilder& gltf) {
        viewer.show(loaded(gltf));
        viewer.change({{"show_lights", false}, {"ground", "off"}});
        viewer.change(Json::parse(R"({"lights": [[0.6, 1, 0.5, 0]]})"));
    }
    void expectPosesOf(const test::GltfBuilder& gltf) {
        const std::vector<double> times = {0.3, 0.85, 0.1};
        show(gltf);
        const Pixels start = picture();
        std::vector<Pixels> then;
        for (const double seconds : times) {
            viewer.change({{"time", seconds}});
            then.push_back(picture());
            EXPECT_GT(differing(then.back(), start), 100u) << seconds;
        }
        viewer.change({{"time", 0.0}});
        EXPECT_EQ(differing(picture(), start), 0u) << "and back";
        EXPECT_GT(viewer.stats().poseMs, 0.0);
        for (std::size_t i = 0; i < times.size(); ++i)
            EXPECT_EQ(differing(then[i], plainAt(gltf, times[i], 0)), 0u) << times[i];
    }
    /// The picture of a scene that starts at that time, drawn in another context.
    Pixels plainAt(const test::GltfBuilder& gltf, double seconds, std::size_t animation) const {
        LoadedScene there = loaded(gltf);
        Warnings none;
        place(there.scene, poseAt(readAnimation(*there.document, none, animation).value(),
                                  there.scene, seconds));
        return plain(there.scene);
    }
};

TEST_F(Deforming, SkinsAreWhereTheirJointsAreAndSoAreTheirShadows) {
    expectPosesOf(test::walkingFigure(8, 8));
}

TEST_F(Deforming, MorphsAreWhereTheirWeightsPutThemAndSoAreTheirShadows) {
    expectPosesOf(test::morphingBall(12, 10));
}

TEST_F(Deforming, APublishedLayoutMovesToo) {
    const test::GltfBuilder gltf = test::walkingFigure(6, 6);
    show(gltf);
    viewer.change({{"left", {{"shadows", "volumes"}, {"multiplicity", "reference-edge"}}}});
    viewer.change({{"time", 0.3}});
    const Pixels then = picture();
    EXPECT_LT(differing(then, plainAt(gltf, 0.3, 0)), 4u);
}

TEST_F(Deforming, AnotherAnimationCanBeChosen) {
    const test::GltfBuilder gltf = test::walkingFigure(8, 8);
    show(gltf);
    EXPECT_EQ(viewer.animations(), (std::vector<std::string>{"walk", "wave", "jump"}));
    viewer.change({{"animation", 1}, {"time", 0.7}});
    EXPECT_EQ(viewer.animationSeconds(), 2.0);
    const Pixels waving = picture();
    viewer.run(Command::nextAnimation);
    EXPECT_EQ(viewer.state().animation, 2u);
    EXPECT_EQ(viewer.state().time, 0.0) << "from its start";
    viewer.run(Command::nextAnimation);
    EXPECT_EQ(viewer.state().animation, 0u);
    EXPECT_THROW(viewer.change({{"animation", 3}}), Error);
    EXPECT_THROW(viewer.change({{"animation", -1}}), Error);
    EXPECT_EQ(viewer.state().animation, 0u);
    viewer.show(test::loadedOf(test::yard().scene()));
    EXPECT_TRUE(viewer.animations().empty());
    EXPECT_THROW(viewer.change({{"animation", 1}}), Error);
    show(gltf); // with the same camera
    EXPECT_EQ(differing(waving, plainAt(gltf, 0.7, 1)), 0u);
}

TEST_F(Deforming, ALostContextKeepsThePose) {
    const test::GltfBuilder gltf = test::morphingBall(12, 10);
    show(gltf);
    viewer.change({{"time", 0.6}});
    const Pixels before = picture();
    viewer.forgetGpu();
    viewer.restoreGpu(context.capabilities());
    EXPECT_EQ(differing(picture(), before), 0u);
}

TEST_F(Animated, LightsOfTheFileGoWithTheirNodesUntilSomebodyMovesThem) {
    const auto placeOf = [&](std::size_t light) {
        return glm::dvec3(viewer.state().lights.at(light).position);
    };
    viewer.show(movingLamps());
    ASSERT_EQ(viewer.state().lights.size(), 2u);
    viewer.change({{"time", 0.5}});
    EXPECT_EQ(placeOf(0), glm::dvec3(0, 2, 0));
    EXPECT_EQ(placeOf(1), glm::dvec3(1, 2, 0));
    const auto kept = toJson(viewer.state());

    // The one that was moved stays there, the other keeps following.
    auto lights = kept["lights"];
    lights[0]["position"] = {7.0, 7.0, 7.0};
    viewer.change({{"lights", lights}});
    viewer.change({{"time", 1.0}});
    EXPECT_EQ(placeOf(0), glm::dvec3(7, 7, 7));
    EXPECT_EQ(placeOf(1), glm::dvec3(2, 2, 0));
    viewer.run(Command::reset);
    EXPECT_EQ(viewer.state().time, 0.0);
    EXPECT_EQ(placeOf(0), glm::dvec3(-1, 2, 0)) << "the file's again";

    // A light from an address, with its digits cut, keeps following the animation.
    viewer.show(movingLamps());
    lights = kept["lights"];
    lights[1]["position"] = {1.0000004, 2.0, 0.0};
    viewer.change({{"lights", lights}, {"time", 0.5}});
    EXPECT_EQ(placeOf(1), glm::dvec3(1, 2, 0));
    viewer.change({{"time", 0.0}});
    EXPECT_EQ(placeOf(0), glm::dvec3(-1, 2, 0));
    EXPECT_EQ(placeOf(1), glm::dvec3(0, 2, 0));
}

TEST_F(Animated, AMovingLightOfTheFileMovesItsShadow) {
    viewer.show(movingLamps());
    viewer.change({{"show_lights", false}, {"ground", "off"}});
    const Pixels start = picture();
    viewer.change({{"playing", true}});
    viewer.frame(1.0);
    viewer.frame(1.4);
    viewer.change({{"playing", false}});
    EXPECT_NEAR(viewer.state().lights[0].position.x, -0.2, 1e-9);
    const Pixels now = picture();
    EXPECT_GT(differing(start, now), 100u);
    EXPECT_EQ(differing(now, plain(movingLamps().scene)), 0u) << "lit from where it is now";
}

TEST_F(Animated, CamerasOfTheFileAreWhereTheirNodesAre) {
    viewer.show(movingLamps());
    ASSERT_EQ(viewer.cameras().size(), 1u);
    EXPECT_EQ(viewer.cameras()[0].title, "eye");
    EXPECT_EQ(viewer.cameras()[0].camera.from, glm::dvec3(-1, 2, 0));
    viewer.change({{"time", 1.0}});
    EXPECT_EQ(viewer.cameras()[0].camera.from, glm::dvec3(1, 2, 0));
}

TEST_F(Animated, PlaysAtItsSpeedAndRests) {
    show("translation", {0, 1, 0, 2, 1, 0});
    EXPECT_TRUE(viewer.frame(10.0));
    EXPECT_FALSE(viewer.wantsFrame());
    viewer.change({{"playing", true}, {"speed", 0.5}});
    viewer.frame(11.0);
    EXPECT_TRUE(viewer.wantsFrame());
    EXPECT_TRUE(viewer.frame(11.5));
    EXPECT_NEAR(viewer.state().time, 0.25, 1e-9);
    viewer.change({{"playing", false}});
    viewer.frame(12.0);
    EXPECT_FALSE(viewer.frame(13.0));
    EXPECT_NEAR(viewer.state().time, 0.25, 1e-9);
}

} // namespace
} // namespace edgeshade::viewer
