// Shadow maps against ray casting: never exact, but close, closer with more texels, and without
// gaps across the edges of the cube.

#include "preprocess/base/error.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/scene_builder.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::Answer;
using test::pointLight;
using test::SceneBuilder;
using test::sun;

constexpr int width = 240, height = 180;

RenderSettings maps(int size, float bias = 1.5f, int pcf = 1) {
    RenderSettings settings;
    settings.shadows = ShadowMethod::map;
    settings.map.size = size;
    settings.map.biasTexels = bias;
    settings.map.pcf = pcf;
    return settings;
}

std::vector<std::uint8_t> draw(const Scene& scene, const Camera& camera, const Light& light,
                               const RenderSettings& settings, bool castMasked = false) {
    return test::drawScene(scene, {camera, {light}, width, height}, settings, castMasked);
}

std::vector<std::uint8_t> drawMask(const Scene& scene, const Camera& camera, const Light& light,
                                   const RenderSettings& settings, bool castMasked = false) {
    return test::drawScene(scene, {camera, {light}, width, height, true}, settings, castMasked);
}

/// Percentage of visible pixels that differ from ray casting: of all, and of those without a
/// boundary of the right answer within one pixel.
struct Wrong {
    double all = 0.0;
    double beyondOnePixel = 0.0;
};

Wrong wrongIn(const Scene& scene, const Camera& camera, const Light& light,
              const RenderSettings& settings, bool castMasked = false) {
    const auto mask = drawMask(scene, camera, light, settings, castMasked);
    const auto answers = test::castMask(scene, camera, light, width, height, 0.0, castMasked);
    int visible = 0, wrong = 0, beyond = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::size_t i = static_cast<std::size_t>(y) * width + x;
            if (answers[i] == Answer::nothing || mask[4 * i + 3] == 0) continue;
            ++visible;
            if ((mask[4 * i] != 0) == (answers[i] == Answer::lit)) continue;
            ++wrong;
            beyond += test::isFlat(answers, width, height, x, y);
        }
    EXPECT_GT(visible, width * height / 4);
    const Wrong result{100.0 * wrong / visible, 100.0 * beyond / visible};
    std::printf("map %d, bias %g, pcf %d: %.3f %% wrong, %.3f %% beyond one pixel\n",
                settings.map.size, static_cast<double>(settings.map.biasTexels), settings.map.pcf,
                result.all, result.beyondOnePixel);
    return result;
}

Scene boxOverFloor() {
    return SceneBuilder().floor(5).box({-1, 0.5f, -1}, {1, 2, 1}).scene();
}
const Camera corner{{5, 4, 6}, {0, 0.5, 0}, 50.0};

const Light lights[] = {pointLight({1.7, 4, 0.7}), pointLight({7, 4.5, -3}), sun({0.5, 1, -0.3}),
                        sun({0, 1, 0})};

TEST(ShadowMap, BoxOverFloorIsNearlyRightAndBetterWithMoreTexels) {
    double coarse = 0.0, fine = 0.0;
    for (const Light& light : lights) {
        coarse += wrongIn(boxOverFloor(), corner, light, maps(512)).all / std::size(lights);
        fine += wrongIn(boxOverFloor(), corner, light, maps(2048)).all / std::size(lights);
    }
    EXPECT_LT(coarse, 0.2);
    EXPECT_LT(fine, 0.5 * coarse);
}

TEST(ShadowMap, OddSizesAndTheSmallestAreRightToo) {
    for (const Light& light : lights) {
        EXPECT_LT(wrongIn(boxOverFloor(), corner, light, maps(1000)).all, 0.2);
        EXPECT_LT(wrongIn(boxOverFloor(), corner, light, maps(16)).all, 12.0);
    }
}

TEST(ShadowMap, WithoutBiasSurfacesShadeThemselves) {
    for (const Light& light : {lights[0], lights[1], lights[2]}) {
        const Wrong biased = wrongIn(boxOverFloor(), corner, light, maps(512));
        const Wrong unbiased = wrongIn(boxOverFloor(), corner, light, maps(512, 0.0f));
        EXPECT_GT(unbiased.beyondOnePixel, biased.beyondOnePixel + 5.0);
    }
}

TEST(ShadowMap, WideKernelsBringNoAcne) {
    for (const Light& light : lights)
        for (const int pcf : {3, 5, 7})
            EXPECT_LT(wrongIn(boxOverFloor(), corner, light, maps(1024, 1.5f, pcf)).all, 0.3);
}

TEST(ShadowMap, LightInsideAClosedBoxLightsNothingOutside) {
    for (const int size : {64, 512}) {
        const auto mask =
            drawMask(SceneBuilder().floor(6).box({-1, 2, -1}, {1, 4, 1}).scene(),
                     {{6, 9, 8}, {0, 1, 0}, 45.0}, pointLight({0.3, 3, 0.2}), maps(size));
        for (std::size_t i = 0; i < mask.size(); i += 4)
            ASSERT_EQ(mask[i], 0);
    }
}

/// A lamp in the middle of a room, with boxes in front of edges and corners of the cube.
Scene room() {
    return SceneBuilder()
        .box({-3, -3, -3}, {3, 3, 3})
        .box({0.7f, -1.3f, -0.4f}, {1.3f, -0.7f, 0.4f})
        .box({-1.4f, -1.2f, -1.3f}, {-1, -0.9f, -0.9f})
        .box({-0.3f, 0.8f, -1.5f}, {0.4f, 1.4f, -0.9f})
        .scene();
}
const Light lamp = pointLight({0, 0, 0});

TEST(ShadowMap, RoomHasNoSeams) {
    // Looks along edges and corners of the cube, where a seam would be a line of wrong pixels.
    for (const glm::dvec3& to :
         {glm::dvec3(3, -3, 0), glm::dvec3(-3, -3, -3), glm::dvec3(0, 3, -3), glm::dvec3(3, 3, 3)})
        for (const int pcf : {1, 3, 7}) {
            const Camera camera{-0.8 * to, to, 70.0};
            const Wrong wrong = wrongIn(room(), camera, lamp, maps(1024, 1.5f, pcf));
            EXPECT_LT(wrong.beyondOnePixel, 0.02)
                << "towards " << to.x << "," << to.y << "," << to.z;
        }
}

int darkPixels(const Scene& scene, const Camera& camera, const Light& light,
               const RenderSettings& settings) {
    const auto mask = drawMask(scene, camera, light, settings);
    int dark = 0;
    for (std::size_t i = 0; i < mask.size(); i += 4)
        dark += mask[i + 3] != 0 && mask[i] == 0;
    return dark;
}

TEST(ShadowMap, FloorAcrossTheCubesEdgesIsAllLit) {
    // At 1 above the floor, the cube's edges lie on it from (1, 1) outwards in both axes.
    const Scene floor = SceneBuilder().floor(8, -1).scene();
    for (const Camera& camera :
         {Camera{{0, 9, 0}, {0, -1, 0}, 50.0}, Camera{{3, 1, 4}, {1, -1, 1}, 60.0}})
        for (const int size : {64, 500, 2048})
            for (const int pcf : {1, 3, 7})
                EXPECT_EQ(darkPixels(floor, camera, lamp, maps(size, 1.5f, pcf)), 0)
                    << size << " texels, pcf " << pcf;
}

TEST(ShadowMap, EmptyRoomIsAllLitButForPointsInItsCorners) {
    // Where walls meet, a texel of one wall may decide for a pixel of the other.
    const Scene empty = SceneBuilder().box({-3, -3, -3}, {3, 3, 3}).scene();
    for (const glm::dvec3& light : {glm::dvec3(0, 0, 0), glm::dvec3(1.3, -2.1, 0.4)})
        for (const glm::dvec3& to : {glm::dvec3(3, -3, 0), glm::dvec3(-3, 3, -3)})
            for (const int size : {128, 1024})
                for (const int pcf : {1, 5})
                    EXPECT_LT(darkPixels(empty, {-0.9 * to, to, 80.0}, pointLight(light),
                                         maps(size, 1.5f, pcf)),
                              width * height / 500)
                        << size << " texels, pcf " << pcf;
}

// A GL that can't hold the cube in one texture gets six, with the same texels.
TEST(ShadowMap, FacesApartLookTheSame) {
    const Scene scene = test::yard().scene();
    for (const int pcf : {1, 3}) {
        RenderSettings settings = maps(256, 1.5f, pcf);
        const Camera camera{{5, 4, 6}, {0, 0.5, 0}, 70.0};
        const auto whole = draw(scene, camera, pointLight({0.3, 1.2, 0.7}), settings);
        settings.map.facesApart = true;
        const auto apart = draw(scene, camera, pointLight({0.3, 1.2, 0.7}), settings);
        std::size_t different = 0;
        for (std::size_t i = 0; i < whole.size(); i += 4)
            different += whole[i] != apart[i];
        // Rounding may put a lookup into the neighbouring texel.
        EXPECT_LE(different, whole.size() / 4 / 1000) << "pcf " << pcf;
    }
}

TEST(ShadowMap, WiderKernelsMakeHalfShadows) {
    // A white floor from above under a directional light at the zenith: lit 255, ambient 89, no
    // other values.
    const Scene scene = SceneBuilder().floor(4).box({-1, 1, -1}, {1, 2, 1}).scene();
    for (const Light& light : {pointLight({0.5, 6, 0.3}), sun({0.5, 1, 0.3})}) {
        int between[2] = {};
        for (const int i : {0, 1}) {
            const auto pixels =
                draw(scene, {{0, 20, 0}, {0, 0, 0}, 20.0}, light, maps(256, 1.5f, i == 0 ? 1 : 5));
            for (std::size_t p = 0; p < pixels.size(); p += 4)
                between[i] += pixels[p] > 95 && pixels[p] < 190;
        }
        EXPECT_EQ(between[0], 0);
        EXPECT_GT(between[1], 300);
    }
}

TEST(ShadowMap, LitPassMeetsTheDepthOfTheAmbientPass) {
    // The lit pass is a different program, with the depth test EQUAL: a position that differed in
    // its last bit would leave holes. Nothing is in shadow here, so that it must look the same as
    // without shadows.
    SceneBuilder builder;
    for (int i = 0; i < 12; ++i) {
        const float x = 0.37f * static_cast<float>(i);
        builder.triangle({-5 + x, 0.1f * x, 5}, {5 + x, 0.13f, 4.1f - x}, {1.1f, 0.3f * x, -5});
    }
    const Scene scene =
        builder.placedBy(glm::rotate(glm::dmat4(1.0), 0.3, {1.0, 2.0, 0.5})).scene();
    for (const Light& light : {pointLight({0.5, 60, 0.3}), sun({0.5, 1, 0.3})}) {
        RenderSettings settings = maps(256, 100.0f); // a bias beyond everything
        RenderSettings none;
        none.shadows = ShadowMethod::none;
        const auto drawn = draw(scene, corner, light, settings);
        const auto expected = draw(scene, corner, light, none);
        int darker = 0;
        for (std::size_t i = 0; i < drawn.size(); i += 4)
            darker += std::abs(drawn[i] - expected[i]) > 1;
        EXPECT_EQ(darker, 0);
    }
}

TEST(ShadowMap, SeveralLightsAndKindsTakeTurns) {
    const Scene scene = boxOverFloor();
    const std::vector<Light> both(std::begin(lights), std::end(lights));
    const auto all = test::drawScene(scene, {corner, both, width, height}, maps(512));
    // Each light alone gives ambient + (1 - ambient) * light; together they are averaged.
    std::vector<double> sum(all.size(), 0.0);
    for (const Light& light : lights) {
        const auto one = draw(scene, corner, light, maps(512));
        for (std::size_t i = 0; i < one.size(); ++i)
            sum[i] += one[i] / 4.0;
    }
    for (std::size_t i = 0; i < all.size(); i += 4)
        ASSERT_NEAR(all[i], sum[i], 3.0);
}

/// A floor and a sheet above it with this alpha mode.
Scene sheetOf(AlphaMode mode, float alpha) {
    Material material;
    material.alphaMode = mode;
    material.baseColorFactor.a = alpha;
    SceneBuilder builder = SceneBuilder().floor(5).box({1, 0, 1}, {2, 1, 2}).material(material);
    builder.quad({-1.5f, 1.5f, 1}, {1.5f, 1.5f, 1}, {1.5f, 1.7f, -1}, {-1.5f, 1.7f, -1});
    return builder.scene();
}

TEST(ShadowMap, WhatIsNotOpaqueCastsWhenAskedTo) {
    const Light light = pointLight({0.3, 4, 0.7});
    for (const bool castMasked : {false, true}) {
        const auto check = [&](const Scene& scene) {
            EXPECT_LT(wrongIn(scene, corner, light, maps(1024), castMasked).all, 0.3);
        };
        check(sheetOf(AlphaMode::mask, 1.0f));
        check(sheetOf(AlphaMode::blend, 0.5f));
    }
    // A map respects holes: a sheet that is all hole casts nothing, though it is a caster.
    const Scene hole = sheetOf(AlphaMode::mask, 0.0f);
    EXPECT_EQ(draw(hole, corner, light, maps(1024), true),
              draw(hole, corner, light, maps(1024), false));
}

TEST(ShadowMap, MirroredStretchedAndFarFromTheOrigin) {
    const glm::dvec3 far(4e6, 123.0, -5e6);
    const glm::dmat4 placed = glm::scale(glm::translate(glm::dmat4(1.0), far), {-1.3, 0.8, 1.1});
    const Scene scene =
        SceneBuilder().floor(5).box({-1, 0.5f, -1}, {1, 2, 1}).placedBy(placed).scene();
    const Camera camera{corner.from + far, corner.to + far, corner.fovDegrees};
    EXPECT_LT(wrongIn(scene, camera, pointLight(glm::dvec3(1.7, 4, 0.7) + far), maps(1024)).all,
              0.2);
    EXPECT_LT(wrongIn(scene, camera, sun({0.5, 1, -0.3}), maps(1024)).all, 0.2);
}

TEST(ShadowMap, SunsLengthDoesNotMatter) {
    const auto expected = draw(boxOverFloor(), corner, sun({0.5, 1, -0.25}), maps(256));
    // Powers of two, so that nothing is rounded.
    for (const double length : {0x1p-600, 0x1p-100, 0x1p100, 0x1p600})
        EXPECT_EQ(draw(boxOverFloor(), corner, sun(length * glm::dvec3(0.5, 1, -0.25)), maps(256)),
                  expected);
}

TEST(ShadowMap, AMapLargerThanTheGlAllowsIsUnavailable) {
    try {
        draw(boxOverFloor(), corner, lights[0], maps(1 << 20));
        FAIL() << "should have thrown";
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), ExitStatus::unavailable);
        EXPECT_NE(std::string(error.what()).find("1048576"), std::string::npos) << error.what();
    }
}

TEST(ShadowMap, NothingAtAllIsTransparent) {
    const auto mask = drawMask(SceneBuilder().scene(), corner, lights[0], maps(64));
    EXPECT_EQ(mask, std::vector<std::uint8_t>(mask.size(), 0));
}

} // namespace
} // namespace edgeshade
