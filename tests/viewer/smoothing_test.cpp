// Antialiasing while nothing moves: the mean of pictures with different samples within their
// pixels.
#include "src/render/accumulation/extended_lights.hpp"
#include "src/render/accumulation/subpixels.hpp"
#include "src/viewer/viewer.hpp"
#include "tests/support/bounded_frame.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/loaded_scene.hpp"
#include "tests/support/scene_builder.hpp"

#include <cstdlib>
#include <gtest/gtest.h>

namespace edgeshade::viewer {
namespace {

using Json = nlohmann::ordered_json;
using Pixels = std::vector<std::uint8_t>;

constexpr int width = 80, height = 60;

class ViewerSmoothing : public testing::Test {
  protected:
    ViewerSmoothing() {
        viewer.resize(width, height, 1.0);
        viewer.show(test::loadedOf(test::yard().scene()));
        viewer.change(Json::parse(R"({"show_lights": false, "ground": "off", "shading": "base",
            "lights": [[0.5, 1, 0.4, 0]], "left": {"shadows": "volumes"},
            "camera": {"from": [5, 7, 9], "to": [0, 0, 0], "fov": 50}})"));
    }

    bool frame() { return viewer.frame(now += 0.016); }

    /// Draws until the viewer wants no more frames; returns the number of pictures in each mean.
    std::vector<std::size_t> settle() {
        std::vector<std::size_t> shown;
        for (int i = 0; i < 20000 && viewer.wantsFrame(); ++i)
            if (frame()) shown.push_back(viewer.smoothing().shown);
        return shown;
    }

    /// The mean of `count` pictures, each drawn separately with all points of its lights.
    std::vector<double> meanOf(std::size_t count) {
        const LoadedScene loaded = test::loadedOf(test::yard().scene());
        const ViewState& state = viewer.state();
        RenderSettings settings;
        settings.shading = state.shading;
        settings.ambient = state.ambient;
        settings.background = state.background;
        settings.layout = bestLayout(context.capabilities());
        Renderer renderer(settings, context.capabilities());
        GpuScene scene = uploadScene(loaded, settings.records(), context.capabilities());
        ExtendedLights extended(context.capabilities());
        std::vector<double> mean(std::size_t{4} * width * height);
        for (std::size_t n = 0; n < count; ++n) {
            FrameRequest request;
            request.frustum = sampledAt(frustumOf(state.camera, 1.0 * width / height),
                                        subpixelOffset(n), width, height);
            request.width = width;
            request.height = height;
            request.lights = state.lights;
            request.lightSamples = state.lightSamples;
            const FrameView view = test::boundedFrame(loaded.scene, false, request);
            drawWithExtents(renderer, extended, scene, loaded, view);
            const Pixels pixels = context.readPixels();
            for (std::size_t i = 0; i < pixels.size(); ++i)
                mean[i] += pixels[i] / static_cast<double>(count);
        }
        return mean;
    }

    static void expectMean(const Pixels& shown, const std::vector<double>& mean) {
        std::size_t different = 0;
        for (std::size_t i = 0; i < shown.size(); ++i)
            different += std::abs(shown[i] - mean[i]) > 1.0;
        EXPECT_EQ(different, 0u);
    }

    gl::HeadlessContext context{test::testPicture(width, height)};
    Viewer viewer{context.capabilities()};
    double now = 1.0;
};

TEST_F(ViewerSmoothing, IsTheMeanOfPicturesSampledWithinThePixels) {
    settle();
    const Pixels usual = context.readPixels();
    viewer.change({{"smooth", 20}});
    EXPECT_EQ(settle(), (std::vector<std::size_t>{0, 4, 16, 20}));
    const Pixels shown = context.readPixels();
    EXPECT_NE(shown, usual);
    expectMean(shown, meanOf(20));
    viewer.change({{"smooth", 1}});
    EXPECT_EQ(settle(), std::vector<std::size_t>{0});
    EXPECT_EQ(context.readPixels(), usual);
    EXPECT_EQ(viewer.smoothing().of, 0u);
}

TEST_F(ViewerSmoothing, SoftShadowsAreCountedForEachOfThem) {
    viewer.change(Json::parse(R"({"lights": [{"direction": [0.5, 1, 0.4], "angle": 8}],
        "light_samples": 9, "smooth": 4})"));
    settle();
    EXPECT_EQ(viewer.smoothing().shown, 4u);
    EXPECT_EQ(viewer.lightPoints().shown, 9u);
    const Pixels shown = context.readPixels();
    expectMean(shown, meanOf(4));
}

TEST_F(ViewerSmoothing, WhatChangesThePictureStartsAnew) {
    viewer.change({{"smooth", 4}});
    settle();
    for (const char* change :
         {R"({"camera": {"from": [5, 7, 9.1]}})", R"({"ambient": 0.2})", R"({"smooth": 5})",
          R"({"lights": [[0.5, 1, 0.5, 0]]})", R"({"background": [1, 0, 0]})"}) {
        viewer.change(Json::parse(change));
        ASSERT_TRUE(frame());
        EXPECT_EQ(viewer.smoothing().shown, 0u) << change;
        settle();
        EXPECT_EQ(viewer.smoothing().shown, viewer.smoothing().of) << change;
    }
    viewer.resize(width, height - 1, 1.0);
    ASSERT_TRUE(frame());
    EXPECT_EQ(viewer.smoothing().shown, 0u);
}

TEST_F(ViewerSmoothing, WhatIsDrawnOverItDoesNot) {
    viewer.change({{"smooth", 4}});
    settle();
    const Pixels before = context.readPixels();
    viewer.change({{"show_lights", true}});
    ASSERT_TRUE(frame());
    EXPECT_EQ(viewer.smoothing().shown, 4u);
    EXPECT_NE(context.readPixels(), before);
    viewer.change({{"show_lights", false}});
    viewer.invalidate();
    ASSERT_TRUE(frame());
    EXPECT_EQ(context.readPixels(), before);
    EXPECT_FALSE(viewer.wantsFrame());
}

TEST_F(ViewerSmoothing, HoursOfSunAndVolumesAreNotSmoothed) {
    viewer.change(Json::parse(R"({"smooth": 4, "debug": "volumes"})"));
    settle();
    EXPECT_EQ(viewer.smoothing().of, 0u);
    viewer.change(Json::parse(R"({"debug": "none", "sun": {"place": [48, 11],
        "time": "2026-03-21T10:00+01:00"}, "sun_hours": true, "sun_hours_step": 60})"));
    settle();
    EXPECT_EQ(viewer.smoothing().of, 0u);
    EXPECT_TRUE(viewer.showsSunHours());
    viewer.change({{"sun_hours", false}});
    settle();
    EXPECT_EQ(viewer.smoothing().shown, 4u);
}

TEST_F(ViewerSmoothing, IsStated) {
    viewer.change({{"smooth", 256}});
    EXPECT_EQ(toJson(viewer.state())["smooth"], 256);
    for (const Json& wrong : {Json(0), Json(257), Json(2.5), Json("4")})
        EXPECT_THROW(viewer.change({{"smooth", wrong}}), Error) << wrong;
    EXPECT_EQ(viewer.state().smooth, 256u);
}

} // namespace
} // namespace edgeshade::viewer
