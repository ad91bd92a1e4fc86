// Points that represent a light's extent, and bounds that hold them all.

#include "src/render/accumulation/subpixels.hpp"
#include "src/shadow/lights/light_extent.hpp"
#include "src/shadow/silhouette/potential_silhouettes.hpp"
#include "tests/support/extended_lights.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/scene_builder.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <set>

namespace edgeshade {
namespace {

using test::discTowards;
using test::panelAt;
using test::sphereAt;

std::vector<Light> everyShape() {
    return {sphereAt({1, 2, 3}, 0.5), panelAt({1, 2, 3}, {2, 0.5}, {0, -1, 0}),
            panelAt({-4, 2, 0}, {1, 1}, glm::normalize(glm::dvec3(1, -1, 0.3))),
            discTowards({3, 10, -2}, 0.53), discTowards({0, 0.001, 0}, 90.0)};
}

TEST(LightExtent, TheFirstPointIsTheCentre) {
    for (const Light& light : everyShape()) {
        const glm::dvec4 first = lightPoints(light, 1).front().position;
        EXPECT_LT(glm::distance(first, regionOf(light).center), 1e-12);
    }
}

TEST(LightExtent, FewerPointsAreTheFirstOfMore) {
    for (const Light& light : everyShape()) {
        const std::vector<Light> few = lightPoints(light, 7), many = lightPoints(light, 300);
        for (std::size_t i = 0; i < few.size(); ++i)
            EXPECT_EQ(few[i].position, many[i].position);
    }
}

TEST(LightExtent, PointsDiffer) {
    for (const Light& light : everyShape()) {
        std::set<std::array<double, 3>> places;
        for (const Light& point : lightPoints(light, mostLightPoints))
            places.insert({point.position.x, point.position.y, point.position.z});
        EXPECT_EQ(places.size(), mostLightPoints);
    }
}

TEST(LightExtent, TheRegionHoldsThemAllAndIsNoLargerThanNeeded) {
    for (const Light& light : everyShape()) {
        const LightRegion region = regionOf(light);
        double farthest = 0.0;
        for (const Light& point : lightPoints(light, mostLightPoints)) {
            EXPECT_EQ(point.position.w, region.center.w);
            farthest = std::max(farthest, glm::distance(point.position, region.center));
        }
        EXPECT_LE(farthest, region.radius * (1.0 + 1e-12));
        EXPECT_GE(farthest, 0.97 * region.radius);
    }
}

TEST(LightExtent, APointOfASunIsADirectionOfLengthOneWithinItsDisc) {
    const double degrees = 10.0;
    const Light light = discTowards({1, 2, 0.5}, degrees);
    const glm::dvec3 center = glm::normalize(glm::dvec3(1, 2, 0.5));
    for (const Light& point : lightPoints(light, 1000)) {
        const glm::dvec3 direction(point.position);
        EXPECT_NEAR(glm::length(direction), 1.0, 1e-12);
        EXPECT_GE(glm::dot(direction, center), std::cos(glm::radians(0.5 * degrees)) - 1e-12);
    }
}

/// Largest difference between the share of points in a disc's middle and the share of its area.
double unevenness(const std::vector<glm::dvec2>& points) {
    double worst = 0.0;
    for (int step = 1; step < 20; ++step) {
        const double radius = 0.05 * step;
        double within = 0.0;
        for (const glm::dvec2& point : points)
            within += glm::length(point) <= radius;
        worst = std::max(worst,
                         std::abs(within / static_cast<double>(points.size()) - radius * radius));
    }
    return worst;
}

// Points on the sphere's surface would crowd at the rim, points in its volume in the middle.
TEST(LightExtent, ASpheresPointsFillItsDiscEvenlyFromEverySide) {
    const std::vector<Light> points = lightPoints(sphereAt({0, 0, 0}, 1.0), 2000);
    for (const glm::dvec3 along :
         {glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0), glm::normalize(glm::dvec3(1, 2, -1))}) {
        const glm::dvec3 right = glm::normalize(glm::cross(along, glm::dvec3(0.3, 0.5, -0.8)));
        const glm::dvec3 up = glm::cross(right, along);
        std::vector<glm::dvec2> seen;
        for (const Light& point : points)
            seen.push_back({glm::dot(right, glm::dvec3(point.position)),
                            glm::dot(up, glm::dvec3(point.position))});
        EXPECT_LT(unevenness(seen), 0.03);
    }
}

TEST(LightExtent, ARectangleLiesAcrossItsDirectionWithItsWidthLevel) {
    const glm::dvec3 facing = glm::normalize(glm::dvec3(1, -1, 0.3));
    const Light light = panelAt({-4, 2, 0}, {3, 1}, facing);
    glm::dvec2 farthest(0.0);
    for (const Light& point : lightPoints(light, 2000)) {
        const glm::dvec3 offset = glm::dvec3(point.position) - glm::dvec3(-4, 2, 0);
        EXPECT_NEAR(glm::dot(offset, facing), 0.0, 1e-12);
        const glm::dvec3 level = glm::normalize(glm::cross(facing, glm::dvec3(0, 1, 0)));
        const double across = glm::dot(offset, level);
        farthest =
            glm::max(farthest, glm::dvec2(std::abs(across), glm::length(offset - across * level)));
        ASSERT_TRUE(point.cone);
        EXPECT_EQ(point.cone->axis, facing);
    }
    EXPECT_NEAR(farthest.x, 1.5, 0.01);
    EXPECT_NEAR(farthest.y, 0.5, 0.01);
}

TEST(LightExtent, TheBallInAnObjectHoldsEveryPointAsTheObjectSeesIt) {
    glm::dmat4 skewed = glm::scale(glm::rotate(glm::dmat4(1.0), 1.0, glm::dvec3(1, 2, 3)),
                                   glm::dvec3(3.0, 0.01, -1.0));
    skewed[1][0] = 0.5;
    for (const glm::dmat4& place :
         {glm::dmat4(1.0), skewed, glm::translate(glm::dmat4(1.0), glm::dvec3(1e6, 3, -1e6)),
          glm::scale(glm::dmat4(1.0), glm::dvec3(1e-6))})
        for (const Light& light : everyShape()) {
            const LightBall ball = ballInObject(regionOf(light), place);
            for (const Light& point : lightPoints(light, 500))
                EXPECT_TRUE(ball.holds(lightInObject(point, place)));
        }
}

TEST(LightExtent, OneListOfSilhouettesServesAllPoints) {
    const Scene scene = test::yard().scene();
    const auto shadow = buildPlanePairs(scene, false).front();
    PotentialSilhouettes silhouettes(23);
    const auto identity = std::make_shared<const int>(0);
    const Light light = sphereAt({1, 4, 1}, 0.4);
    const LightBall around = ballInObject(regionOf(light), glm::dmat4(1.0));
    for (const Light& point : lightPoints(light, 40)) {
        silhouettes.beginFrame(identity);
        const SilhouetteList& list =
            *silhouettes.of({shadow, 0, 0, around}, lightInObject(point, glm::dmat4(1.0)));
        EXPECT_GT(list.size(), 0u);
        EXPECT_LT(list.size(), shadow->pairs.size());
    }
    EXPECT_EQ(silhouettes.made(), 1u);
}

TEST(LightExtent, InSomePlaneIsAskedOfEveryPoint) {
    // The first point is in the plane of the box's top, the second one in no plane.
    const Scene scene = test::SceneBuilder().box({-1, 0, -1}, {1, 1, 1}).scene();
    const auto shadow = buildPlanePairs(scene, false).front();
    PotentialSilhouettes silhouettes(23);
    silhouettes.beginFrame(std::make_shared<const int>(0));
    const LightBall around{glm::vec4(3, 1.5f, 4, 1), 2.0f};
    EXPECT_TRUE(silhouettes.of({shadow, 0, 0, around}, {3, 1, 4, 1})->lightInPlane);
    EXPECT_FALSE(silhouettes.of({shadow, 0, 0, around}, {3, 1.5f, 4, 1})->lightInPlane);
    EXPECT_TRUE(silhouettes.of({shadow, 0, 0, around}, {3, 1, 4.5f, 1})->lightInPlane);
}

TEST(Subpixels, TheFirstIsTheMiddleAndAllAreWithinThePixel) {
    EXPECT_EQ(subpixelOffset(0), glm::dvec2(0.0));
    glm::dvec2 sum(0.0);
    for (std::uint64_t n = 0; n < mostSubpixels; ++n) {
        const glm::dvec2 offset = subpixelOffset(n);
        EXPECT_LE(std::max(std::abs(offset.x), std::abs(offset.y)), 0.5);
        sum += offset;
    }
    EXPECT_LT(glm::length(sum) / static_cast<double>(mostSubpixels), 0.01);
}

TEST(Subpixels, ASampleIsWhereItsOffsetSays) {
    const Frustum whole = frustumOf(Camera{{0, 0, 5}, {0, 0, 0}, 60.0}, 2.0);
    const Frustum moved = sampledAt(whole, {0.25, -0.5}, 200, 100);
    const auto windowAt = [](const Frustum& frustum, double x, double y) {
        return frustum.windowAt({2.0 * x / 200 - 1.0, 2.0 * y / 100 - 1.0});
    };
    const glm::dvec2 there = windowAt(whole, 30.75, 39.5), here = windowAt(moved, 30.5, 40.0);
    EXPECT_NEAR(there.x, here.x, 1e-12);
    EXPECT_NEAR(there.y, here.y, 1e-12);
}

} // namespace
} // namespace edgeshade
