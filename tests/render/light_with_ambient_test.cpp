// The light that is drawn together with ambient light: shadow leaves exactly the ambient share of
// both, to a unit of the picture's bytes, and nothing remains in the picture's alpha.
#include "tests/support/hard_lights.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/scene_builder.hpp"

#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::pointLight;
using test::sun;
using test::TestView;
using Picture = std::vector<std::uint8_t>;

constexpr int width = 240, height = 180;
const Camera outside{{5, 4, 6}, {0, 0.5, 0}, 50.0};

Picture draw(const TestView& view, ShadowMethod shadows, float ambient,
             const Scene& scene = test::yard().scene()) {
    RenderSettings settings;
    settings.shadows = shadows;
    settings.ambient = ambient;
    return test::drawScene(scene, view, settings);
}

/// Expects the sum of ambient light and each light drawn separately, with the light only where its
/// mask is lit.
void expectSum(const std::vector<Light>& lights, float ambient, std::optional<int> slices = {},
               const Scene& scene = test::yard().scene()) {
    TestView view{outside, lights, width, height};
    view.depth.slices = slices;
    const Picture drawn = draw(view, ShadowMethod::volumes, ambient, scene);
    TestView part = view;
    part.drawnLights.emplace();
    const Picture ambientAlone = draw(part, ShadowMethod::none, ambient, scene);
    std::vector<Picture> alone, masks;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        part.drawnLights = {i};
        alone.push_back(draw(part, ShadowMethod::none, ambient, scene));
        TestView mask = view;
        mask.mask = true;
        mask.lights = {lights[i]};
        masks.push_back(draw(mask, ShadowMethod::volumes, ambient, scene));
    }
    const int tolerated = static_cast<int>(lights.size()) + (lights.size() > 1);
    int shaded = 0;
    for (std::size_t at = 0; at < drawn.size(); at += 4) {
        bool allLit = true;
        for (std::size_t c = 0; c < 3; ++c) {
            int expected = ambientAlone[at + c];
            for (std::size_t i = 0; i < lights.size(); ++i) {
                const bool lit = masks[i][at] != 0 || masks[i][at + 3] == 0;
                allLit &= lit;
                if (lit) expected += alone[i][at + c] - ambientAlone[at + c];
            }
            ASSERT_NEAR(drawn[at + c], expected, allLit && lights.size() == 1 ? 0 : tolerated)
                << "pixel " << at / 4 << ", channel " << c;
        }
        shaded += !allLit;
        ASSERT_EQ(drawn[at + 3], 255) << "pixel " << at / 4;
    }
    EXPECT_GT(shaded, 300);
}

TEST(LightWithAmbient, IsTakenFromWhereItIsInShadow) {
    for (const float ambient : {0.0f, 0.1f, 0.35f, 0.9f}) {
        expectSum({pointLight({2.5, 4, 1.2})}, ambient);
        expectSum({sun({0.5, 1.0, 0.4})}, ambient);
    }
}

TEST(LightWithAmbient, GoesWithRangesSlicesAndMoreLights) {
    Light lamp = pointLight({0.2, 2.5, 1.2});
    lamp.range = 4.5;
    expectSum({lamp}, 0.2f);
    expectSum({lamp}, 0.2f, 3);
    expectSum({sun({0.5, 1.0, 0.4})}, 0.35f, 4);
    expectSum({lamp, sun({0.5, 1.0, 0.4}), pointLight({-3, 3, 2})}, 0.2f, 2);
}

// More sheets under the first light than a stencil can count: its casters are split into groups,
// and the second light is drawn with ambient light.
TEST(LightWithAmbient, ComesBeforeLightsWhoseCastersComeInGroups) {
    test::SceneBuilder builder = test::yard();
    for (int i = 0; i < 300; ++i) {
        const double y = 1.0 + 0.05 * i;
        builder.quad({1.0, y, 1.0}, {1.0, y, 1.4}, {1.4, y, 1.4}, {1.4, y, 1.0});
    }
    expectSum({sun({0.02, 1.0, 0.03}), sun({1.0, 0.3, 0.2})}, 0.3f, {}, builder.scene());
    expectSum({sun({1.0, 0.3, 0.2}), sun({0.02, 1.0, 0.03})}, 0.3f, 2, builder.scene());
}

// Everything visible is in the box's shadow: nothing is counted, and everything is darkened.
TEST(LightWithAmbient, LeavesAmbientLightWhereAllIsInShadow) {
    const Scene scene = test::SceneBuilder().box({-9, -9, -9}, {9, 9, 9}).scene();
    TestView view{{{0, 0, 0}, {1, 0.2, 0.1}, 60.0}, {pointLight({0, 40, 0})}, 64, 64};
    RenderSettings settings;
    settings.ambient = 0.3f;
    const Picture drawn = test::drawScene(scene, view, settings);
    view.drawnLights.emplace();
    const Picture ambientAlone = test::drawScene(scene, view, settings);
    for (std::size_t i = 0; i < drawn.size(); ++i)
        ASSERT_NEAR(drawn[i], ambientAlone[i], 1);
}

// Two coinciding floors are as bright as one, whichever light comes first.
TEST(LightWithAmbient, SurfacesThatCoincideAreLitOnceByEveryLight) {
    const Scene one = test::SceneBuilder().floor(4).box({-1, 1, -1}, {1, 2, 1}).scene();
    const Scene two = test::SceneBuilder().floor(4).floor(4).box({-1, 1, -1}, {1, 2, 1}).scene();
    const TestView view{
        outside, {sun({0.5, 1, 0.4}), pointLight({2, 4, 1}), sun({-0.3, 1, 0})}, width, height};
    for (const ShadowMethod shadows :
         {ShadowMethod::volumes, ShadowMethod::map, ShadowMethod::none})
        EXPECT_EQ(draw(view, shadows, 0.2f, two), draw(view, shadows, 0.2f, one));
    if (!test::hasDerivatives()) return;
    RenderSettings coarse;
    coarse.maskScale = 2;
    EXPECT_EQ(test::drawScene(two, view, coarse), test::drawScene(one, view, coarse));
}

TEST(LightWithAmbient, MapsAreDrawnSoToo) {
    const TestView view{outside, {pointLight({2.5, 4, 1.2})}, width, height};
    const Picture mapped = draw(view, ShadowMethod::map, 0.3f);
    const Picture exact = draw(view, ShadowMethod::volumes, 0.3f);
    int different = 0;
    for (std::size_t at = 0; at < mapped.size(); at += 4) {
        different += std::abs(mapped[at] - exact[at]) > 1;
        ASSERT_EQ(mapped[at + 3], 255);
    }
    EXPECT_LT(different, width * height / 50);
}

} // namespace
} // namespace edgeshade
