// Surfaces seen edge-on, by the eye (a pixel wide and as deep as the scene) or by the light: the
// rounding of interpolated values must not put them into shadow.
#include "tests/support/headless.hpp"
#include "tests/support/scene_builder.hpp"

#include <gtest/gtest.h>

namespace edgeshade {
namespace {

constexpr int width = 960, height = 540;

/// Number of dark pixels of a box whose left side, like all others in view, the light shines on.
int darkPixels(const Camera& camera, const Light& light) {
    test::TestView view;
    view.camera = camera;
    view.lights = {light};
    view.width = width;
    view.height = height;
    view.mask = true;
    RenderSettings settings;
    settings.shadows = ShadowMethod::primitiveMap;
    const auto mask = test::drawScene(
        test::SceneBuilder().box({0, -0.5f, -1}, {1, 0.5f, 1}).scene(), view, settings);
    int dark = 0;
    for (std::size_t i = 0; i < mask.size(); i += 4)
        dark += mask[i + 3] != 0 && mask[i] == 0;
    return dark;
}

class SurfacesFromTheirEdge : public ::testing::Test {
  protected:
    void SetUp() override {
        if (test::testLimits() != gl::Limits::device) GTEST_SKIP() << "needs float textures";
        if (!test::hasDerivatives()) GTEST_SKIP() << "needs derivatives";
    }
};

/// The eye is to the left of the left side's plane, which is in the picture's right half. Single
/// pixels of an outline may show what is behind it.
TEST_F(SurfacesFromTheirEdge, AreNotInTheirOwnShadow) {
    int pictures = 0, spotted = 0;
    for (double beside = 0.001; beside < 0.1; beside += 0.0046)
        for (const Light& light :
             {test::sun({-1, 0.3, 0.5}), test::pointLight({-3, 1, 2}), test::sun({-0.3, 0.1, 1})}) {
            const Camera camera{{-beside, 0.03, 5.0}, {-1.3, 0.0, 0.0}, 45.0};
            const int dark = darkPixels(camera, light);
            EXPECT_LE(dark, 1) << beside << " beside it";
            spotted += dark;
            ++pictures;
        }
    EXPECT_LT(spotted, pictures / 10);
}

constexpr Camera leftAndTop{{-4.0, 2.6, 0.1}, {0.3, 0.0, 0.0}, 45.0};

TEST_F(SurfacesFromTheirEdge, AreLitWhereTheLightAllButLiesInThem) {
    for (const double aside : {1e-4, 3e-4, 1e-3}) {
        EXPECT_LE(darkPixels(leftAndTop, test::sun({-aside, 0.8, 0.61})), 1) << aside;
        EXPECT_LE(darkPixels(leftAndTop, test::pointLight({-aside, 2.3, 4.1})), 1) << aside;
        // In all six tiles of its map.
        EXPECT_LE(darkPixels(leftAndTop, test::pointLight({-aside, 0.61, 0.27})), 1) << aside;
    }
}

TEST_F(SurfacesFromTheirEdge, AreDarkWhereTheLightGrazesThem) {
    // The sine of the angle between the light and the side is below the bound (docs/method.md,
    // C47).
    const int leftSide = darkPixels(leftAndTop, test::sun({0.0, 0.8, 0.61}));
    EXPECT_GT(leftSide, width * height / 20);
    for (const double aside : {1e-8, 1e-7, 1e-6}) {
        EXPECT_EQ(darkPixels(leftAndTop, test::sun({-aside, 0.8, 0.61})), leftSide) << aside;
        EXPECT_EQ(darkPixels(leftAndTop, test::pointLight({-aside, 2.3, 4.1})), leftSide) << aside;
        EXPECT_EQ(darkPixels(leftAndTop, test::pointLight({-aside, 0.61, 0.27})), leftSide)
            << aside;
    }
}

} // namespace
} // namespace edgeshade
