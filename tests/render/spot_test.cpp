// Spot lights: what their cones light, compared with ray casting, and what is left out as out of
// reach.

#include "src/gl/headless_context.hpp"
#include "src/shadow/lights/light_cone.hpp"
#include "src/shadow/view/light_reach.hpp"
#include "tests/support/bounded_frame.hpp"
#include "tests/support/hard_lights.hpp"
#include "tests/support/mask_case.hpp"
#include "tests/support/pixel_place.hpp"
#include "tests/support/scene_builder.hpp"

#include <cstdlib>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::Case;
using test::Random;
using test::SceneBuilder;

constexpr double rightAngle = std::numbers::pi / 2.0;

Light spot(const glm::dvec3& position, const glm::dvec3& at, double outer, double inner = 0.0) {
    Light light{glm::dvec4(position, 1.0)};
    light.cone = Cone{glm::normalize(at - position), inner, outer};
    return light;
}

Light randomSpot(Random& random) {
    const glm::dvec3 place = random.inCube() * random.magnitude(-2, 1);
    const double outer = random.below(4) == 0 ? rightAngle : random.magnitude(-3, 0.19);
    return spot(place, place + random.inCube(), std::min(outer, rightAngle));
}

/// A point that the spot lights, at most `reach` away; some just inside the cone's edge.
glm::dvec3 pointIn(const Light& light, double reach, Random& random) {
    const glm::dmat4 worldFromCone = glm::inverse(coneFromWorld(light));
    const double angle = light.cone->outer * (random.below(3) ? 1.0 : random.uniform(0, 1));
    const double around = random.uniform(0, 2.0 * std::numbers::pi);
    const double distance = reach * (random.below(3) ? 1.0 : random.uniform(0, 1));
    const glm::dvec3 inCone(std::sin(angle) * std::cos(around), std::sin(angle) * std::sin(around),
                            std::cos(angle));
    return glm::dvec3(worldFromCone * glm::dvec4(distance * inCone, 1.0));
}

TEST(SpotLight, PlanesBallsAndPyramidsHoldItsCone) {
    Random random(3);
    for (int i = 0; i < 3000; ++i) {
        const Light light = randomSpot(random);
        const double reach = random.magnitude(-2, 2);
        const Ball ball = ballAround(light, reach);
        const auto planes = planesAround(light);
        ASSERT_EQ(planes.size(), 9u);
        EXPECT_LE(ball.radius, reach * 1.0001);
        for (int p = 0; p < 20; ++p) {
            const glm::dvec3 point = pointIn(light, reach, random);
            ASSERT_LE(glm::distance(point, ball.center), ball.radius * (1.0 + 1e-9));
            for (const glm::dvec4& plane : planes)
                ASSERT_GE(glm::dot(plane, glm::dvec4(point, 1.0)), -1e-9 * (reach + 100.0));
        }
    }
}

TEST(SpotLight, PlanesAreCloseToTheCone) {
    const Light light = spot({1, 2, 3}, {1, 2, 0}, 0.5);
    const auto isInside = [&](double angle, double around) {
        const glm::dvec3 direction(std::sin(angle) * std::cos(around),
                                   std::sin(angle) * std::sin(around), -std::cos(angle));
        for (const glm::dvec4& plane : planesAround(light))
            if (glm::dot(glm::dvec3(plane), direction) < 0.0) return false;
        return true;
    };
    for (double around = 0.0; around < 6.3; around += 0.1) {
        EXPECT_TRUE(isInside(0.5, around));
        EXPECT_FALSE(isInside(0.55, around));
        EXPECT_FALSE(isInside(3.0, around)) << "behind it";
    }
}

TEST(SpotLight, ReachHoldsEveryVisiblePoint) {
    Random random(7);
    constexpr int width = 240, height = 180;
    int checked = 0, small = 0;
    for (int i = 0; i < 6000; ++i) {
        FrameView view;
        const bool orthographic = i % 4 == 0;
        const Camera camera{3.0 * random.inCube(), 3.0 * random.inCube(), random.uniform(5, 150)};
        const double near = random.magnitude(-3, 0), farthest = near * random.magnitude(0.5, 3);
        view.frustum =
            frustumOf(camera, static_cast<double>(width) / height,
                      orthographic ? std::optional(random.magnitude(-1, 1)) : std::nullopt);
        view.width = width;
        view.height = height;
        view.slices = {{near, std::numeric_limits<double>::infinity()}};
        view.farPlane = 2.0 * farthest;
        view.farthestDepth = farthest;
        Light light = randomSpot(random);
        double reach = random.magnitude(-2, 1);
        if (i % 3 == 0) { // without a range: limited by the visible geometry
            view.visible.add(glm::dvec3(light.position) + 0.5 * reach * random.inCube());
            view.visible.add(glm::dvec3(light.position) + 0.5 * reach * random.inCube());
        } else {
            light.range = reach;
        }
        const PixelRectangle pixels = lightReach(view, view.slices[0], light);
        small += !pixels.empty() && pixels.width * pixels.height < width * height / 4;
        for (int p = 0; p < 60; ++p) {
            const glm::dvec3 point = pointIn(light, reach, random);
            if (!view.visible.empty() &&
                glm::any(
                    glm::greaterThan(glm::max(view.visible.low - point, point - view.visible.high),
                                     glm::dvec3(0.0))))
                continue;
            const double depth = depthOf(view.frustum, point);
            if (depth < near || depth > farthest) continue;
            const glm::dvec4 clip = clipFromView(view.frustum, near, view.farPlane) *
                                    view.frustum.viewFromWorld * glm::dvec4(point, 1.0);
            const auto place = test::placeInPicture(clip, view);
            if (!place) continue;
            ++checked;
            ASSERT_TRUE(test::holds(pixels, *place))
                << "spot " << i << ": " << place->x << ", " << place->y;
        }
    }
    EXPECT_GT(checked, 5'000);
    EXPECT_GT(small, 300) << "the whole picture is right, but no help";
}

const Camera outside{{5, 4, 6}, {0, 0.5, 0}, 50.0};
const Camera within{{0.2, 1.4, 2.6}, {-0.6, 0.6, 0}, 80.0};

Case yardLitBy(const Light& light, const Camera& camera = outside) {
    return {test::yard().scene(), camera, light};
}

TEST(SpotLight, MasksAreThoseOfRays) {
    for (const Camera& camera : {outside, within})
        for (const Light& light :
             {spot({0.2, 4, 1.2}, {0, 0, 0}, 0.6), spot({-3, 1.5, 2.5}, {1, 0.5, 0}, 0.4, 0.4),
              spot({2.15, 2.6, 1.9}, {0, 0, -1}, 1.2)}) {
            test::expectRight(yardLitBy(light, camera));
            Case sliced = yardLitBy(light, camera);
            sliced.slices = 3;
            test::expectRight(sliced, MultiplicityMethod::plane);
        }
}

TEST(SpotLight, MasksOfHardCasesAreThoseOfRays) {
    Light ranged = spot({0.2, 3, 1.2}, {0, 0, 0}, 0.7);
    ranged.range = 3.2;
    Light grazing = spot({6, 0.3, 0.2}, {0, 0.2, 0}, 0.25, 0.1);
    for (const Light& light :
         {ranged, grazing, spot({0.2, 4, 1.2}, {0.2, 0, 1.2}, rightAngle), // everything is below it
          spot({0.2, 4, 1.2}, {0.2, 9, 1.2}, rightAngle, rightAngle),      // everything is above it
          spot({-1.5, 1, -0.5}, {0, 1, 0}, 0.8),                           // inside a box
          spot({300, 400, 200}, {0, 0.5, 0}, 0.004, 0.0039),               // distant and narrow
          spot({5, 4, 6}, {0, 0.5, 0}, 0.3)})                              // at the eye
        for (const auto method : {MultiplicityMethod::plane, MultiplicityMethod::referenceEdge}) {
            RenderSettings settings;
            settings.multiplicity = method;
            const test::Outcome outcome = test::run(yardLitBy(light), settings);
            EXPECT_EQ(outcome.wrongBeyondOnePixel, 0);
            EXPECT_LE(outcome.wrong, test::maskWidth * test::maskHeight / 500);
            EXPECT_GT(outcome.shadow, 50);
        }
}

TEST(SpotLight, MasksOfPlacedAndScaledScenesAreThoseOfRays) {
    const auto placed = [](const glm::dmat4& worldFromYard, double wider) {
        const auto moved = [&](const glm::dvec3& point) {
            return glm::dvec3(worldFromYard * glm::dvec4(point, 1.0));
        };
        return Case{test::yard().placedBy(worldFromYard).scene(),
                    {moved({5, 4, 6}), moved({0, 0.5, 0}), 50.0},
                    spot(moved({0.2, 4, 1.2}), moved({0, 0, 0}), 0.5 * wider)};
    };
    const glm::dmat4 one(1.0);
    for (const double size : {1e-5, 1e5})
        test::expectRight(placed(glm::scale(one, glm::dvec3(size)), 1.0),
                          MultiplicityMethod::plane);
    test::expectRight(placed(glm::translate(one, glm::dvec3(4e6, 100, -5e6)), 1.0),
                      MultiplicityMethod::plane);
    // Sheared, stretched and mirrored: a cone in the world is no cone in the yard.
    const glm::dmat4 distorted({-1.5, 0, 0, 0}, {0.3, 0.7, 0, 0}, {0, 0, 1.2, 0}, {0, 0, 0, 1});
    test::expectRight(placed(distorted, 1.3), MultiplicityMethod::plane);
}

TEST(SpotLight, RandomMasksAreThoseOfRays) {
    Random random(21);
    for (int i = 0; i < 24; ++i) {
        Light light = spot(3.0 * random.inCube() + glm::dvec3(0, 3.2, 0), random.inCube(),
                           random.uniform(0.05, rightAngle));
        light.cone->inner = light.cone->outer * random.uniform(0, 1);
        if (i % 3 == 0) light.range = random.uniform(1.5, 6.0);
        for (const ShadowMethod shadows : {ShadowMethod::volumes, ShadowMethod::primitiveMap}) {
            if (shadows == ShadowMethod::primitiveMap && test::testLimits() != gl::Limits::device)
                continue;
            RenderSettings settings;
            settings.shadows = shadows;
            const test::Outcome outcome =
                test::run(yardLitBy(light, i % 2 ? within : outside), settings);
            EXPECT_LE(outcome.wrongBeyondOnePixel, shadows == ShadowMethod::volumes ? 0 : 1)
                << "spot " << i;
        }
    }
}

TEST(SpotLight, MapsAndCoarseMasksAreNearlyThoseOfRays) {
    RenderSettings map, coarse;
    map.shadows = ShadowMethod::map;
    coarse.maskScale = 2;
    for (const Camera& camera : {outside, within}) {
        const Case lit = yardLitBy(spot({0.2, 4, 1.2}, {0, 0, 0}, 0.6), camera);
        EXPECT_LE(test::run(lit, map).wrongBeyondOnePixel,
                  test::maskWidth * test::maskHeight / 100);
        if (!test::hasDerivatives()) continue;
        EXPECT_LE(test::run(lit, coarse).wrongBeyondOnePixel,
                  test::maskWidth * test::maskHeight / 200);
    }
}

TEST(SpotLight, FallsOffBetweenItsAngles) {
    // A white floor seen from above, under a spot at height 3 that points down.
    constexpr int size = 64;
    const Scene scene = SceneBuilder().floor(8).scene();
    const auto expectRight = [&](const Light& light) {
        RenderSettings settings;
        settings.ambient = 0.2f;
        const auto pixels =
            test::drawScene(scene, {{{0, 10, 0}, {0, 0, 0}, 45.0}, {light}, size, size}, settings);
        const double half = 10.0 * std::tan(glm::radians(22.5));
        int lit = 0;
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const double away =
                    half * std::hypot((2.0 * x + 1.0) / size - 1.0, (2.0 * y + 1.0) / size - 1.0);
                const double cosine = 3.0 / std::hypot(3.0, away);
                const double outer = std::cos(light.cone->outer),
                             inner = std::cos(light.cone->inner);
                if (inner - outer < 1e-3 && std::abs(cosine - outer) < 0.01) continue;
                const double share =
                    std::clamp((cosine - outer) / std::max(inner - outer, 1e-3), 0.0, 1.0);
                lit += share > 0.0;
                EXPECT_NEAR(pixels[static_cast<std::size_t>(4 * (y * size + x))],
                            255.0 * (0.2 + 0.8 * cosine * share * share), 2.0)
                    << x << ", " << y;
            }
        EXPECT_GT(lit, 100);
    };
    for (const auto& [outer, inner] :
         {std::pair(0.9, 0.0), {0.9, 0.6}, {0.6, 0.6}, {rightAngle, 0.3}})
        expectRight(spot({0, 3, 0}, {0, 0, 0}, outer, inner));
}

/// Number of vertices of the volumes of many boxes in rows.
std::size_t runsWith(const Light& light) {
    SceneBuilder builder;
    builder.floor(60);
    for (int x = -25; x <= 25; ++x)
        for (int z = -25; z <= 25; ++z)
            builder.box({2.0 * x, 0.2f, 2.0 * z}, {2.0 * x + 1.0, 1, 2.0 * z + 1.0});
    const gl::HeadlessContext context(test::testPicture(240, 180));
    RenderSettings settings;
    settings.layout = bestLayout(context.capabilities());
    const LoadedScene loaded{{}, builder.scene(), {}, buildPlanePairs(builder.scene(), false), {},
                             {}};
    const FrameView view = test::boundedFrame(
        loaded.scene, loaded.settings.castMasked,
        {frustumOf({{0, 6, 14}, {0, 0, 0}, 60.0}, 4.0 / 3.0), 240, 180, {light}, {}});
    GpuScene gpu = uploadScene(loaded, settings.records(), context.capabilities());
    Renderer renderer(settings, context.capabilities());
    renderer.draw(gpu, view);
    return renderer.vertexRuns();
}

TEST(SpotLight, WhatIsBesideItCostsNothing) {
    const std::size_t all = runsWith({{0, 3, 0, 1}});
    const std::size_t few = runsWith(spot({0, 3, 0}, {0, 0, 1}, 0.7));
    EXPECT_GT(few, 0u);
    EXPECT_LT(few, all / 3);
    EXPECT_EQ(runsWith(spot({0, 3, 0}, {0, 9, 0.1}, 0.7)), 0u) << "it shines upwards";
}

} // namespace
} // namespace edgeshade
