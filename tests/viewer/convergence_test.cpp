// Shadows of lights with an extent: hard while something moves, then softer from picture to
// picture.
#include "src/viewer/viewer.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/loaded_scene.hpp"
#include "tests/support/scene_builder.hpp"

#include <chrono>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <thread>

namespace edgeshade::viewer {
namespace {

using Json = nlohmann::ordered_json;
using Pixels = std::vector<std::uint8_t>;

constexpr int width = 160, height = 120;

class ViewerSoftness : public testing::Test {
  protected:
    ViewerSoftness() {
        viewer.resize(width, height, 1.0);
        viewer.show(test::loadedOf(
            test::SceneBuilder().floor(4).box({-1, 0.5f, -1}, {1, 1.5f, 1}).scene()));
        viewer.change(Json::parse(R"({"show_lights": false, "ambient": 0.1, "shading": "base",
            "camera": {"from": [4, 6, 6], "to": [0, 0, 0]}, "left": {"shadows": "volumes"}})"));
    }

    void shine(const std::string& lights, int samples) {
        viewer.change({{"lights", Json::parse(lights)}, {"light_samples", samples}});
    }
    static constexpr const char* hard = R"([{"position": [1, 5, 2]}])";
    static constexpr const char* soft = R"([{"position": [1, 5, 2], "radius": 0.6}])";

    bool frame() { return viewer.frame(now += 0.016); }

    /// Draws until the viewer wants no more frames; returns the pictures by their number of points.
    std::map<std::size_t, Pixels> settle() {
        std::map<std::size_t, Pixels> pictures;
        for (int i = 0; i < 20000 && viewer.wantsFrame(); ++i) {
            const LightPoints points = viewer.lightPoints();
            if (frame())
                pictures[viewer.lightPoints().shown] = context.readPixels();
            else if (points.shown == points.of) // a primitive map is under construction
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return pictures;
    }

    gl::HeadlessContext context{test::testPicture(width, height)};
    Viewer viewer{context.capabilities()};
    double now = 1.0;
};

double apart(const Pixels& a, const Pixels& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += std::pow(static_cast<double>(a[i]) - b[i], 2);
    return std::sqrt(sum / static_cast<double>(a.size()));
}

TEST_F(ViewerSoftness, TheFirstPictureIsAsHardAsTheCentre) {
    shine(hard, 64);
    ASSERT_TRUE(frame());
    const Pixels expected = context.readPixels();
    EXPECT_EQ(viewer.lightPoints().of, 0u);
    shine(soft, 64);
    ASSERT_TRUE(frame());
    EXPECT_EQ(context.readPixels(), expected);
    EXPECT_EQ(viewer.lightPoints().shown, 0u);
    EXPECT_EQ(viewer.lightPoints().of, 64u);
    EXPECT_TRUE(viewer.wantsFrame());
}

TEST_F(ViewerSoftness, PicturesComeAfterPowersOfFourAndNoneIsWorseThanTheOneBefore) {
    shine(soft, 1024);
    const auto pictures = settle();
    std::vector<std::size_t> points;
    for (const auto& [count, picture] : pictures)
        points.push_back(count);
    EXPECT_EQ(points, (std::vector<std::size_t>{0, 4, 16, 64, 256, 1024}));
    double last = INFINITY;
    for (const auto& [count, picture] : pictures) {
        const double error = apart(picture, pictures.at(1024));
        EXPECT_LT(error, last) << count;
        last = error;
    }
    EXPECT_GT(apart(pictures.at(0), pictures.at(1024)), 3.0);
    EXPECT_LT(apart(pictures.at(64), pictures.at(1024)), 1.5);
    EXPECT_FALSE(viewer.wantsFrame());
    EXPECT_EQ(viewer.lightPoints().shown, 1024u);
}

TEST_F(ViewerSoftness, AtRestAMapOfTheWholeLightCountsAsVolumesDo) {
    shine(soft, 64);
    const Pixels byVolumes = settle().at(64);
    viewer.change(Json::parse(R"({"left": {"shadows": "primitive-map"}})"));
    settle(); // with volumes, until there is a map
    shine(soft, 16);
    settle();
    shine(soft, 64);
    const Pixels byMap = settle().at(64);
    const auto lights = viewer.stats().lights;
    ASSERT_EQ(lights.size(), 1u);
    if (context.capabilities().limits == gl::Limits::device) {
        EXPECT_EQ(lights[0].method, "primitive-map") << lights[0].why;
    }
    EXPECT_LT(apart(byMap, byVolumes), 0.3);
}

TEST_F(ViewerSoftness, WhatMovesStartsAnew) {
    shine(soft, 16);
    settle();
    viewer.change(Json::parse(R"({"camera": {"from": [4, 6, 6.1], "to": [0, 0, 0]}})"));
    ASSERT_TRUE(frame());
    EXPECT_EQ(viewer.lightPoints().shown, 0u);
    settle();
    EXPECT_EQ(viewer.lightPoints().shown, 16u);
    for (const char* change : {R"({"lights": [{"position": [1, 5, 2.1], "radius": 0.6}]})",
                               R"({"lights": [{"position": [1, 5, 2.1], "radius": 0.5}]})",
                               R"({"light_samples": 5})", R"({"left": {"shadows": "map"}})"}) {
        viewer.change(Json::parse(change));
        ASSERT_TRUE(frame());
        EXPECT_EQ(viewer.lightPoints().shown, 0u) << change;
        settle();
    }
}

TEST_F(ViewerSoftness, WhatChangesColoursAloneStaysSoft) {
    shine(soft, 16);
    settle();
    viewer.change(Json::parse(R"({"ambient": 0.2})"));
    ASSERT_TRUE(frame());
    EXPECT_EQ(viewer.lightPoints().shown, 16u);
    EXPECT_FALSE(viewer.wantsFrame());
    viewer.invalidate();
    ASSERT_TRUE(frame());
    EXPECT_EQ(viewer.lightPoints().shown, 16u);
}

TEST_F(ViewerSoftness, BothSidesOfASplitBecomeSoft) {
    shine(soft, 64);
    const Pixels whole = settle().at(64);
    viewer.change(Json::parse(R"({"split": true, "right": {"shadows": "volumes"}})"));
    const Pixels split = settle().at(64);
    // The line between the sides is drawn over the picture.
    std::size_t different = 0;
    for (std::size_t i = 0; i < whole.size(); i += 4)
        different += whole[i] != split[i];
    EXPECT_LT(different, std::size_t{10} * height);
    viewer.change(Json::parse(R"({"right": {"shadows": "none"}})"));
    const Pixels none = settle().at(64);
    EXPECT_GT(apart(none, split), 1.0);
}

TEST_F(ViewerSoftness, ALostContextComesBackSoft) {
    shine(soft, 16);
    const Pixels before = settle().at(16);
    viewer.forgetGpu();
    EXPECT_EQ(viewer.lightPoints().of, 0u);
    viewer.restoreGpu(context.capabilities());
    EXPECT_EQ(settle().at(16), before);
}

TEST_F(ViewerSoftness, ExtentsAreStated) {
    const auto light = [&](const char* text) {
        viewer.change({{"lights", {Json::parse(text)}}});
        return viewer::toJson(viewer.state())["lights"][0];
    };
    EXPECT_EQ(light(R"({"position": [1, 5, 2], "radius": 0.5})")["radius"], 0.5);
    const Json panel = light(R"({"position": [1, 5, 2], "size": [2, 1], "facing": [0, -2, 0]})");
    EXPECT_EQ(panel["size"], Json::parse("[2.0, 1.0]"));
    EXPECT_EQ(panel["facing"], Json::parse("[0.0, -1.0, 0.0]"));
    EXPECT_NEAR(light(R"({"direction": [1, 5, 2], "angle": 0.53})")["angle"].get<double>(), 0.53,
                1e-12);
    for (const char* wrong :
         {R"({"position": [1, 5, 2], "radius": 0})", R"({"position": [1, 5, 2], "radius": "x"})",
          R"({"position": [1, 5, 2], "angle": 1})", R"({"direction": [1, 5, 2], "radius": 1})",
          R"({"direction": [1, 5, 2], "angle": 91})", R"({"position": [1, 5, 2], "size": [1, 0]})",
          R"({"position": [1, 5, 2], "facing": [0, 1, 0]})",
          R"({"position": [1, 5, 2], "size": [1, 1], "facing": [0, 0, 0]})",
          R"({"position": [1, 5, 2], "size": [1, 1], "radius": 1})"})
        EXPECT_THROW(light(wrong), Error) << wrong;
    EXPECT_THROW(viewer.change({{"light_samples", 0}}), Error);
    EXPECT_THROW(viewer.change({{"light_samples", 4097}}), Error);
}

TEST_F(ViewerSoftness, NothingIsCountedWhereNoSideTakesPoints) {
    shine(soft, 16);
    viewer.change(Json::parse(R"({"left": {"shadows": "none"}})"));
    settle();
    EXPECT_EQ(viewer.lightPoints().of, 0u);
    viewer.change(Json::parse(R"({"left": {"shadows": "map"}})"));
    settle();
    EXPECT_EQ(viewer.lightPoints().shown, 16u);
    viewer.change(Json::parse(R"({"debug": "volumes", "left": {"shadows": "volumes"}})"));
    settle();
    EXPECT_EQ(viewer.lightPoints().of, 0u);
}

TEST_F(ViewerSoftness, ASunThatIsDownIsNotCounted) {
    viewer.change(Json::parse(R"({"lights": [{"direction": [0, 1, 0], "angle": 2}], "sun":
        {"place": [48, 11], "time": "2026-06-21T01:00+02:00"}})"));
    settle();
    EXPECT_EQ(viewer.lightPoints().of, 0u);
    viewer.change(Json::parse(R"({"sun": {"time": "2026-06-21T12:00+02:00"}})"));
    settle();
    EXPECT_EQ(viewer.lightPoints().shown, 64u);
}

} // namespace
} // namespace edgeshade::viewer
