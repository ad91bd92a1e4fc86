// Colours with known values: sRGB base colour * (ambient + sum of lights / count * Lambert).

#include "tests/support/headless.hpp"
#include "tests/support/scene_builder.hpp"

#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::pointLight;
using test::SceneBuilder;
using test::sun;

constexpr int size = 64;
const Camera down{{0, 10, 0}, {0, 0, 0}, 45.0};

/// The red value in the middle of a floor seen from above.
int middle(const std::vector<Light>& lights, float ambient, float linearRed,
           ShadowMethod shadows = ShadowMethod::volumes, bool roof = false) {
    Material material;
    material.baseColorFactor = {linearRed, 0.0f, 0.0f, 1.0f};
    SceneBuilder builder;
    builder.material(material).floor(8);
    if (roof) builder.quad({2, 3, 1}, {4, 3, 1}, {4, 3, -1}, {2, 3, -1});
    RenderSettings settings;
    settings.ambient = ambient;
    settings.shadows = shadows;
    const auto pixels = test::drawScene(builder.scene(), {down, lights, size, size}, settings);
    return pixels[4 * (size / 2 * size + size / 2)];
}

TEST(Shading, LinearFactorsBecomeDisplayValues) {
    EXPECT_NEAR(middle({sun({0, 1, 0})}, 1.0f, 1.0f), 255, 1);
    EXPECT_NEAR(middle({sun({0, 1, 0})}, 1.0f, 0.2140411f), 128, 1); // sRGB 0.5
}

TEST(Shading, LambertIsTheCosine) {
    // A directional light 60 degrees off: 0.2 + 0.8 * 0.5 = 0.6.
    EXPECT_NEAR(middle({sun({std::sqrt(3.0), 1, 0})}, 0.2f, 1.0f), 153, 2);
}

TEST(Shading, LightsShareWhatAmbientLeaves) {
    // 0.2 + 0.4 * 1 + 0.4 * 0.5 = 0.8.
    EXPECT_NEAR(middle({sun({0, 1, 0}), sun({std::sqrt(3.0), 1, 0})}, 0.2f, 1.0f), 204, 2);
}

TEST(Shading, OneOfTwoLightsShaded) {
    // The roof over x in 2..4 at height 3 shades the middle from (6, 6, 0), not from above:
    // 0.2 + 0.4 * 1.
    const std::vector<Light> lights = {pointLight({0, 6, 0}), pointLight({6, 6, 0})};
    EXPECT_NEAR(middle(lights, 0.2f, 1.0f, ShadowMethod::volumes, true), 153, 2);
}

TEST(Shading, WithoutShadowsEverythingIsLit) {
    const std::vector<Light> lights = {pointLight({6, 6, 0})};
    // 0.2 + 0.8 * cos 45 degrees = 0.766.
    EXPECT_NEAR(middle(lights, 0.2f, 1.0f, ShadowMethod::none, true), 195, 2);
    EXPECT_NEAR(middle(lights, 0.2f, 1.0f, ShadowMethod::volumes, true), 51, 1);
}

/// A picture of a floor of linear red 0.2140411, sRGB 0.5, below a roof that shades its middle from
/// (6, 6, 0); either may be unlit.
std::vector<std::uint8_t> roofedFloor(bool unlitFloor, bool unlitRoof,
                                      const std::vector<Light>& lights,
                                      const RenderSettings& settings, bool mask = false) {
    Material floor;
    floor.baseColorFactor = {0.2140411f, 0.0f, 0.0f, 1.0f};
    floor.unlit = unlitFloor;
    Material roof = floor;
    roof.unlit = unlitRoof;
    SceneBuilder builder;
    builder.material(floor).floor(8).material(roof);
    builder.quad({2, 3, 1}, {4, 3, 1}, {4, 3, -1}, {2, 3, -1});
    test::TestView view{down, lights, size, size};
    view.mask = mask;
    return test::drawScene(builder.scene(), view, settings);
}

int middleOf(const std::vector<std::uint8_t>& pixels) {
    return pixels[4 * (size / 2 * size + size / 2)];
}

/// Every kind of shading.
std::vector<RenderSettings> everyShading() {
    std::vector<RenderSettings> all(4);
    all[0].shadows = ShadowMethod::none;
    all[1].shadows = ShadowMethod::volumes;
    all[2].shadows = ShadowMethod::map;
    all[3].shadows = ShadowMethod::volumes;
    all[3].maskScale = 2;
    if (!test::hasDerivatives()) all.pop_back();
    for (RenderSettings& settings : all)
        settings.ambient = 0.2f;
    return all;
}

TEST(Shading, AnUnlitSurfaceHasItsColourWhateverTheLight) {
    const Light over = pointLight({6, 6, 0}); // the roof shades the middle from it
    Light near = pointLight({0, 3, 0});
    near.range = 1.0; // does not reach the floor
    for (const std::vector<Light>& lights :
         {std::vector<Light>{over}, {over, sun({0, 1, 0})}, {sun({0, 1, 0}), over, over}, {near}})
        for (const RenderSettings& settings : everyShading())
            EXPECT_NEAR(middleOf(roofedFloor(true, false, lights, settings)), 128, 1);
}

TEST(Shading, AnUnlitSurfaceCasts) {
    const std::vector<Light> lights = {pointLight({6, 6, 0})};
    for (const RenderSettings& settings : everyShading())
        EXPECT_EQ(middleOf(roofedFloor(false, true, lights, settings)),
                  middleOf(roofedFloor(false, false, lights, settings)));
}

TEST(Shading, AMaskShowsWhereLightFallsOnUnlitSurfaces) {
    const std::vector<Light> lights = {pointLight({6, 6, 0})};
    for (const RenderSettings& settings : everyShading())
        EXPECT_EQ(roofedFloor(true, true, lights, settings, true),
                  roofedFloor(false, false, lights, settings, true));
}

TEST(Shading, OfSurfacesThatCoincideTheFirstMayBeUnlit) {
    Material green;
    green.baseColorFactor = {0.0f, 0.2140411f, 0.0f, 1.0f};
    Material red;
    red.baseColorFactor = {0.2140411f, 0.0f, 0.0f, 1.0f};
    red.unlit = true;
    SceneBuilder builder;
    builder.material(red).floor(8).material(green).floor(8);
    const std::vector<Light> lights = {sun({0, 1, 0}), sun({0, 1, 0.1})};
    for (const RenderSettings& settings : everyShading()) {
        const auto pixels = test::drawScene(builder.scene(), {down, lights, size, size}, settings);
        EXPECT_NEAR(middleOf(pixels), 128, 1);
        EXPECT_EQ(pixels[4 * (size / 2 * size + size / 2) + 1], 0);
    }
}

} // namespace
} // namespace edgeshade
