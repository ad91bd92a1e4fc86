// Shadows projected onto planes against ray casting: right on the planes, and elsewhere only
// surfaces turned away from the light are dark.

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

constexpr int width = 200, height = 150;

Material colored(const glm::vec3& color) {
    Material material;
    material.baseColorFactor = glm::vec4(color, 1.0f);
    return material;
}
const Material red = colored({1, 0, 0}), blue = colored({0, 0, 1});

struct PlanarCase {
    Scene scene; ///< red surfaces are on the planes
    Camera camera;
    Light light;
    std::size_t planes = 1;
    std::optional<Frustum> frustum{};
    bool castMasked = false;

    test::TestView view(bool mask) const {
        test::TestView view{camera, {light}, width, height, mask};
        view.frustum = frustum;
        return view;
    }
    std::vector<std::uint8_t> draw(ShadowMethod shadows, bool mask) const {
        RenderSettings settings;
        settings.shadows = shadows;
        settings.planes = planes;
        settings.ambient = mask ? 0.35f : 1.0f;
        return test::drawScene(scene, view(mask), settings, castMasked);
    }
};

struct Counted {
    int onPlanes = 0, dark = 0, wrong = 0, wrongBeyondOnePixel = 0; ///< on planes
    int others = 0, othersWrong = 0; ///< compared with the mask of these surfaces alone
};

/// `alone`: a scene with only the surfaces that are not on planes.
Counted compare(const PlanarCase& test, const Scene& alone) {
    const auto mask = test.draw(ShadowMethod::planar, true);
    const auto colors = test.draw(ShadowMethod::none, false);
    const Frustum frustum = test.view(true).seen();
    const auto cast = [&](const Scene& scene) {
        return test::castMask(scene, frustum, test.light, width, height, 0.0, test.castMasked);
    };
    const auto answers = cast(test.scene), byThemselves = cast(alone);
    Counted counted;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::size_t i = static_cast<std::size_t>(y) * width + x;
            if (mask[4 * i + 3] == 0 || answers[i] == Answer::nothing) continue;
            const Answer drawn = mask[4 * i] == 0 ? Answer::shadow : Answer::lit;
            const bool flat = test::isFlat(answers, width, height, x, y);
            if (colors[4 * i] > colors[4 * i + 2]) {
                ++counted.onPlanes;
                counted.dark += drawn == Answer::shadow;
                counted.wrong += drawn != answers[i];
                counted.wrongBeyondOnePixel += drawn != answers[i] && flat;
            } else if (byThemselves[i] != Answer::nothing && flat &&
                       test::isFlat(byThemselves, width, height, x, y)) {
                ++counted.others;
                counted.othersWrong += drawn != byThemselves[i];
            }
        }
    return counted;
}

void expectRight(const PlanarCase& test, const Scene& alone = SceneBuilder().scene(),
                 bool darkens = true) {
    const Counted counted = compare(test, alone);
    EXPECT_GT(counted.onPlanes, 500);
    if (darkens) {
        EXPECT_GT(counted.dark, 50) << "the case should have shadows";
    }
    EXPECT_EQ(counted.wrongBeyondOnePixel, 0);
    EXPECT_LE(counted.wrong, width * height / 500);
    EXPECT_EQ(counted.othersWrong, 0);
}

SceneBuilder floorAnd(const glm::vec3& low, const glm::vec3& high) {
    return SceneBuilder().material(red).floor(6).material(blue).box(low, high);
}
const Camera corner{{5, 4, 6}, {0, 0.5, 0}, 50.0};

TEST(PlanarShadows, BoxOverFloor) {
    const glm::vec3 low{-1, 0.5f, -1}, high{1, 2, 1};
    const Scene alone = SceneBuilder().box(low, high).scene();
    for (const Light& light :
         {pointLight({1.7, 4, 0.7}), pointLight({7, 4.5, -3}), sun({0.5, 1, -0.3}), sun({0, 1, 0})})
        expectRight({floorAnd(low, high).scene(), corner, light}, alone);
}

TEST(PlanarShadows, StandingOnTheFloorAndThroughIt) {
    for (const float y : {0.0f, -0.7f})
        for (const Light& light : {pointLight({1.7, 4, 0.7}), sun({0.5, 1, -0.3})})
            expectRight({floorAnd({-1, y, -1}, {1, 1.2f, 1}).scene(), corner, light});
}

// Casters above the lamp, at its height or below the floor cast nothing onto the floor; a caster
// that crosses the lamp's height casts with the part below.
TEST(PlanarShadows, LampBetweenCastersAndPlane) {
    const Light lamp = pointLight({0.3, 1.5, 0.2});
    expectRight({floorAnd({-1, 2, -1}, {1, 3, 1}).scene(), corner, lamp}, SceneBuilder().scene(),
                false);
    expectRight({floorAnd({-1, -2, -1}, {1, -1, 1}).scene(), corner, lamp}, SceneBuilder().scene(),
                false);
    expectRight({floorAnd({1, 0.6f, -1}, {1.4f, 3, 1}).scene(), corner, lamp});
    expectRight({floorAnd({-1.5f, 0.5f, -1}, {-0.5f, 1.5f, 1}).scene(), corner, lamp});
}

// Light from behind the eye, from ahead, and with the eye in shadow.
TEST(PlanarShadows, EyeInShadow) {
    const Scene scene = floorAnd({-3, 3, -3}, {3, 3.2f, 3}).scene();
    for (const Light& light :
         {pointLight({0.5, 6, 4}), pointLight({0.5, 6, -4}), sun({0.2, 1, 0.3})})
        expectRight({scene, {{0.3, 1.5, 2}, {0, 0.2, -4}, 70.0}, light});
}

// The floor seen from below, and lit from below.
TEST(PlanarShadows, TheSideTurnedAwayIsDark) {
    const Scene scene = floorAnd({-1, -2, -1}, {1, -1, 1}).scene();
    const Camera below{{4, -4, 5}, {0, -0.3, 0}, 50.0};
    const Counted away = compare({scene, below, sun({0.2, 1, 0.3})}, SceneBuilder().scene());
    EXPECT_GT(away.onPlanes, 500);
    EXPECT_EQ(away.dark, away.onPlanes);
    expectRight({scene, below, sun({0.2, -1, 0.3})});
    // Light in the plane itself lights nothing.
    const Counted grazed = compare({scene, corner, sun({1, 0, 0.3})}, SceneBuilder().scene());
    EXPECT_EQ(grazed.dark, grazed.onPlanes);
}

// A floor and a wall, of which one or both are used as planes.
TEST(PlanarShadows, SeveralPlanesAndNoMoreThanAskedFor) {
    const auto room = [](const Material& wall) {
        return SceneBuilder()
            .material(red)
            .floor(6)
            .material(wall)
            .quad({-4, 0, -4}, {4, 0, -4}, {4, 5, -4}, {-4, 5, -4})
            .material(blue)
            .box({-1, 0.5f, -1}, {1, 2, 1})
            .scene();
    };
    const Camera camera{{5, 4, 8}, {0, 1, -2}, 60.0};
    for (const Light& light : {pointLight({1, 2.5, 5}), sun({0.2, 0.5, 1})}) {
        expectRight({room(red), camera, light, 2});
        // Without its plane the wall looks as if it were alone.
        const Scene wall =
            SceneBuilder().quad({-4, 0, -4}, {4, 0, -4}, {4, 5, -4}, {-4, 5, -4}).scene();
        const Counted floorAlone = compare({room(blue), camera, light, 1}, wall);
        EXPECT_EQ(floorAlone.wrongBeyondOnePixel, 0);
        EXPECT_GT(floorAlone.others, 500);
        EXPECT_LT(floorAlone.othersWrong,
                  500); // the box's sides, which differ from the wall alone
    }
}

// More planes than the stencil has bits, each darkened once.
TEST(PlanarShadows, MorePlanesThanBits) {
    SceneBuilder builder = SceneBuilder().material(red);
    for (int i = 0; i < 10; ++i) {
        const float x = static_cast<float>(i) - 5, y = 0.05f * static_cast<float>(i);
        builder.quad({x, y, 5}, {x + 1, y, 5}, {x + 1, y, -5}, {x, y, -5});
    }
    builder.material(blue).box({-2, 1, -1}, {2, 1.5f, 1});
    expectRight({builder.scene(), {{3, 6, 6}, {0, 0, 0}, 50.0}, pointLight({0.4, 5, 0.3}), 10});
}

TEST(PlanarShadows, MirroredStretchedTiltedAndFarFromTheOrigin) {
    const glm::dvec3 far(4e6, 123.0, -5e6);
    glm::dmat4 placed = glm::translate(glm::dmat4(1.0), far);
    placed = glm::rotate(placed, 0.4, {0.6, 0.2, 0.5});
    placed = glm::scale(placed, {-1.3, 0.8, 1.1});
    const Scene scene = floorAnd({-1, 0.5f, -1}, {1, 2, 1}).placedBy(placed).scene();
    const Camera camera{corner.from + far, corner.to + far, corner.fovDegrees};
    expectRight({scene, camera, pointLight(glm::dvec3(1.7, 4, 0.7) + far)});
    expectRight({scene, camera, sun({0.9, 1, -0.3})});
}

TEST(PlanarShadows, OrthographicPictures) {
    PlanarCase test{floorAnd({-1, 0.5f, -1}, {1, 2, 1}).scene(), corner, sun({0.5, 1, -0.3})};
    test.frustum = frustumOf(corner, static_cast<double>(width) / height, 9.0);
    for (const Light& light : {sun({0.5, 1, -0.3}), pointLight({1.7, 4, 0.7})}) {
        test.light = light;
        expectRight(test);
    }
}

// BLEND surfaces cast only if the settings say so.
TEST(PlanarShadows, SeeThroughCasters) {
    Material blend;
    blend.alphaMode = AlphaMode::blend;
    PlanarCase test{SceneBuilder()
                        .material(red)
                        .floor(6)
                        .material(blend)
                        .quad({-1, 1, 1}, {1, 1, 1}, {1, 1.5f, -1}, {-1, 1.5f, -1})
                        .scene(),
                    corner, pointLight({0.4, 5, 0.3})};
    expectRight(test, SceneBuilder().scene(), false);
    test.castMasked = true;
    expectRight(test);
}

// In colours shadow is darkened once, where two casters overlap as well as where one casts.
TEST(PlanarShadows, DarkenOnce) {
    const Scene scene = SceneBuilder()
                            .floor(6)
                            .box({-1, 0.5f, -1}, {1, 1, 1})
                            .box({-1, 2, -1}, {1, 2.5f, 1})
                            .scene();
    PlanarCase test{scene, {{0, 9, 6}, {0, 0, 0}, 50.0}, sun({0.3, 1, 0.2})};
    RenderSettings settings;
    settings.planes = 1;
    std::vector<std::vector<std::uint8_t>> pictures;
    for (const ShadowMethod shadows : {ShadowMethod::volumes, ShadowMethod::planar}) {
        settings.shadows = shadows;
        pictures.push_back(test::drawScene(scene, test.view(false), settings));
    }
    const auto mask = test.draw(ShadowMethod::planar, true);
    int differ = 0;
    for (std::size_t i = 0; i < mask.size(); i += 4)
        differ += std::abs(pictures[0][i] - pictures[1][i]) > 2;
    EXPECT_LT(differ, width * height / 100); // the lower box's top, which isn't one of the planes
}

} // namespace
} // namespace edgeshade
