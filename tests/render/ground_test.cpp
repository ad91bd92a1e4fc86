// The ground beneath a scene: its position, the shadows on it, and its appearance.

#include "preprocess/scene/ground.hpp"
#include "src/scene/ground_text.hpp"
#include "src/shadow/view/framing.hpp"
#include "tests/support/mask_case.hpp"
#include "tests/support/scene_builder.hpp"

#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::drawScene;
using test::expectRight;
using test::pointLight;
using test::SceneBuilder;
using test::sun;

/// Two boxes without a floor, one of them high up.
SceneBuilder boxes() {
    SceneBuilder builder;
    builder.box({-1, 0, -1}, {1, 1, 1}).box({0.5f, 1.5f, -0.5f}, {1.5f, 2, 0.5f});
    return builder;
}

Scene grounded(SceneBuilder builder, const Ground& ground = {}) {
    Scene scene = builder.scene();
    EXPECT_TRUE(addGround(scene, ground));
    return scene;
}

TEST(Ground, LiesBeneathAllAndCastsNothing) {
    const Scene scene = grounded(boxes());
    const Batch& ground = scene.batches.back();
    ASSERT_TRUE(ground.ground);
    EXPECT_LT(ground.worldFromBatch[3].y, 0.0);
    EXPECT_GT(ground.worldFromBatch[3].y, -0.01);
    for (std::size_t i = 0; i < ground.geometry->indices.size(); i += 3) {
        const auto& [positions, indices] =
            std::tie(ground.geometry->positions, ground.geometry->indices);
        const glm::vec3 a = positions[indices[i]], b = positions[indices[i + 1]],
                        c = positions[indices[i + 2]];
        EXPECT_GT(glm::cross(b - a, c - a).y, 0.0f) << "looks up";
    }
    EXPECT_TRUE(castersOf(ground, scene.materials, true).indices.empty());
}

TEST(Ground, IsNothingOfTheScenesOwn) {
    const Scene without = boxes().scene(), with = grounded(boxes());
    EXPECT_EQ(worldBounds(with).low, worldBounds(without).low);
    EXPECT_EQ(worldBounds(with).high, worldBounds(without).high);
    EXPECT_EQ(with.triangleCount(), without.triangleCount());
    const glm::dvec3 aside(0.5, 0.4, 1.0);
    EXPECT_EQ(framingCamera(with, 45.0, 1.5, aside).from,
              framingCamera(without, 45.0, 1.5, aside).from);
}

TEST(Ground, ASceneWithoutVerticesHasNone) {
    Scene nothing;
    EXPECT_FALSE(addGround(nothing, {}));
    EXPECT_TRUE(nothing.batches.empty());
    EXPECT_TRUE(nothing.materials.empty());
}

TEST(Ground, WhereThereIsAFloorOrNone) {
    EXPECT_FALSE(hasFloor(boxes().scene()));
    EXPECT_FALSE(hasFloor(Scene()));
    EXPECT_FALSE(hasFloor(grounded(boxes()))) << "but for one that was laid";
    EXPECT_TRUE(hasFloor(boxes().floor(2.0f).scene()));
    EXPECT_TRUE(hasFloor(boxes().floor(1.5f, 0.1f).scene()));
    EXPECT_FALSE(hasFloor(boxes().floor(0.5f).scene())) << "too small";
    EXPECT_FALSE(hasFloor(boxes().floor(2.0f, 1.2f).scene())) << "too high";
    EXPECT_TRUE(hasFloor(SceneBuilder().floor(1.0f).scene())) << "a floor alone";
}

TEST(Ground, ReceivesShadowsExactly) {
    for (const Light& light : {sun({1, 2, 0.5}), sun({0.3, 0.1, 1}), pointLight({-2, 4, 2.2}),
                               pointLight({0.2, 1.3, 0.1})})
        expectRight({grounded(boxes()), {{2, 4, 6}, {0, 0, 0}, 50.0}, light});
}

TEST(Ground, ReceivesShadowsInSlicesAndWithoutPerspective) {
    test::Case sliced{grounded(boxes()), {{2, 4, 6}, {0, 0, 0}, 50.0}, sun({1, 2, 0.5})};
    sliced.slices = 3;
    expectRight(sliced, MultiplicityMethod::plane);
    test::Case orthographic = sliced;
    const Camera away{{20, 40, 60}, {0, 0, 0}, 50.0};
    orthographic.frustum = frustumOf(away, double(test::maskWidth) / test::maskHeight, 9.0);
    expectRight(orthographic, MultiplicityMethod::plane);
}

TEST(Ground, CastsNothingWhereMaskedSurfacesDo) {
    // The light comes from below, through the ground.
    test::Case below{
        grounded(boxes().floor(3.0f, 3.0f)), {{2, 2, 9}, {0, 2, 0}, 50.0}, sun({0.2, -1, 0.3})};
    below.castMasked = true;
    expectRight(below, MultiplicityMethod::plane);
}

constexpr int size = 48;
const glm::vec3 background(0.8f, 0.6f, 0.5f);

using Pixel = std::array<int, 3>;

Pixel at(const std::vector<std::uint8_t>& pixels, int x, int y) {
    const std::size_t i = 4 * static_cast<std::size_t>(y * size + x);
    return {pixels[i], pixels[i + 1], pixels[i + 2]};
}

/// A view from above of a box in the middle, with its shadow to the right.
std::vector<std::uint8_t> fromAbove(const Ground& ground, const std::vector<Light>& lights,
                                    Shading shading, double height = 12.0,
                                    ShadowMethod shadows = ShadowMethod::volumes) {
    RenderSettings settings;
    settings.shading = shading;
    settings.background = background;
    settings.shadows = shadows;
    SceneBuilder builder;
    builder.box({-0.5f, 0, -0.5f}, {0.5f, 2, 0.5f});
    return drawScene(grounded(builder, ground),
                     {{{0, height, 0.01}, {0, 0, 0}, 45.0}, lights, size, size}, settings);
}

const Light slanted = sun({-1, 1, 0});
const Pixel behind = {204, 153, 128}; // the background in bytes

void expectBackground(const Pixel& pixel) {
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(pixel[c], behind[c], 2) << "channel " << c;
}

TEST(Ground, ACatcherShowsShadowAndNothingElse) {
    Light bright = slanted, red = slanted;
    bright.color = glm::vec3(900.0f);
    bright.photometric = true;
    red.color = {0.7f, 0.1f, 0.1f};
    const Light other = pointLight({3, 8, 3});
    for (const Shading shading : {Shading::base, Shading::full})
        for (const auto& lights : std::vector<std::vector<Light>>{
                 {slanted}, {bright}, {red}, {slanted, other}, {slanted, other, bright}}) {
            SCOPED_TRACE(std::to_string(lights.size()) + " lights");
            const auto pixels = fromAbove({}, lights, shading);
            for (const auto& [x, y] : {std::pair(2, 2), {40, 5}, {24, 44}, {8, 24}})
                expectBackground(at(pixels, x, y));
            const Pixel shadow = at(pixels, 31, 24);
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_LT(shadow[c], behind[c] - 20) << "channel " << c;
        }
}

TEST(Ground, ACatchersShadowIsGreyOfTheBackground) {
    for (const Shading shading : {Shading::base, Shading::full}) {
        const Pixel shadow = at(fromAbove({}, {slanted}, shading), 31, 24);
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(static_cast<double>(shadow[c]) / behind[c],
                        static_cast<double>(shadow[0]) / behind[0], 0.012);
    }
}

TEST(Ground, ACatcherIsTheSameByEveryMethod) {
    const auto counted = fromAbove({}, {slanted}, Shading::full);
    for (const ShadowMethod method : {ShadowMethod::map, ShadowMethod::primitiveMap}) {
        const auto other = fromAbove({}, {slanted}, Shading::full, 12.0, method);
        for (const auto& [x, y] : {std::pair(31, 24), {2, 2}, {40, 40}})
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_NEAR(at(counted, x, y)[c], at(other, x, y)[c], 2);
    }
}

TEST(Ground, ACatchersShadowFadesInTheDistance) {
    // The box is 2 high: its shadow ends at 2 / tan(12 degrees), where it is fainter.
    const Light low = sun({-1, 0.16, 0});
    const auto pixels = fromAbove({}, {low}, Shading::base, 40.0);
    const int near = at(pixels, 26, 24)[0], far = at(pixels, 33, 24)[0];
    EXPECT_LT(near, far - 15);
    EXPECT_LT(far, behind[0] - 3);
    expectBackground(at(pixels, 46, 24));
}

TEST(Ground, IsAFloorOfAColour) {
    const Ground floor{GroundMaterial::surface, {0.2f, 0.4f, 0.2f}};
    for (const Shading shading : {Shading::base, Shading::full}) {
        const auto pixels = fromAbove(floor, {slanted}, shading);
        const Pixel lit = at(pixels, 8, 24), shadow = at(pixels, 31, 24);
        EXPECT_GT(lit[1], lit[0] + 20);
        EXPECT_LT(shadow[1], lit[1] - 20);
    }
}

TEST(Ground, IsNotSeenFromBelow) {
    for (const Ground& ground : {Ground{}, Ground{GroundMaterial::surface, glm::vec3(0.0f)}}) {
        const auto pixels = fromAbove(ground, {slanted}, Shading::full, -12.0);
        expectBackground(at(pixels, 2, 2));
        expectBackground(at(pixels, 31, 24));
    }
}

TEST(Ground, ItsTextsAreReadAndWritten) {
    for (const std::string text : {"off", "catcher", "#8090a0", "#000000", "#ffffff"}) {
        const auto ground = groundFromText(text);
        ASSERT_TRUE(ground) << text;
        EXPECT_EQ(textOf(*ground), text);
    }
    for (const std::string text : {"", "on", "#12345", "#1234567", "#12345g", "Catcher", "8090a0"})
        EXPECT_FALSE(groundFromText(text)) << text;
}

} // namespace
} // namespace edgeshade
