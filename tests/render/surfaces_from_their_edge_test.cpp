// Surfaces that are seen from their edge, a pixel wide and as deep as the scene: rounding of what a
// rasteriser interpolates must not put them into their own shadow.
#include "tests/support/headless.hpp"
#include "tests/support/scene_builder.hpp"

#include <gtest/gtest.h>

namespace edgeshade {
namespace {

constexpr int width = 960, height = 540;

/// Of a box whose left side the light shines on, from an eye so far to the left of that side's
/// plane, in the picture's right half: how many pixels of it are dark.
int darkPixels(double beside, const Light& light) {
    test::TestView view;
    view.camera = {{-beside, 0.03, 5.0}, {-1.3, 0.0, 0.0}, 45.0};
    view.lights = {light};
    view.width = width;
    view.height = height;
    view.mask = true;
    RenderSettings settings;
    settings.shadows = ShadowMethod::primitiveMap;
    const auto mask = test::drawScene(
        test::SceneBuilder().box({0, -0.5f, -1}, {1, 0.5f, 1}).scene(), view, settings);
    // The front is lit, too: nothing that is seen is dark, but for single pixels of an outline that
    // show what is behind it.
    int dark = 0;
    for (std::size_t i = 0; i < mask.size(); i += 4)
        dark += mask[i + 3] != 0 && mask[i] == 0;
    return dark;
}

TEST(SurfacesFromTheirEdge, AreNotInTheirOwnShadow) {
    if (test::testLimits() != gl::Limits::device) GTEST_SKIP() << "needs float textures";
    if (!test::hasDerivatives()) GTEST_SKIP() << "needs derivatives";
    int pictures = 0, spotted = 0;
    for (double beside = 0.001; beside < 0.1; beside += 0.0046)
        for (const Light& light :
             {test::sun({-1, 0.3, 0.5}), test::pointLight({-3, 1, 2}), test::sun({-0.3, 0.1, 1})}) {
            const int dark = darkPixels(beside, light);
            EXPECT_LE(dark, 1) << beside << " beside it";
            spotted += dark;
            ++pictures;
        }
    EXPECT_LT(spotted, pictures / 10);
}

} // namespace
} // namespace edgeshade
