// Casters that are wholly in the shadow of others are left out, and what is left is closed and
// shades as much (docs/method.md, C43). No GL is needed.
#include "src/shadow/culling/kept_records.hpp"
#include "src/shadow/culling/shadowed_casters.hpp"
#include "src/shadow/geometry/light_extent.hpp"
#include "src/shadow/geometry/light_region.hpp"
#include "src/shadow/geometry/light_shape.hpp"
#include "src/shadow/silhouette/light_facings.hpp"
#include "tests/support/hard_lights.hpp"
#include "tests/support/plane_pair_chain.hpp"
#include "tests/support/scene_builder.hpp"

#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::Random;

/// Boxes that lie over each other.
Scene pile(Random& random, int count) {
    test::SceneBuilder builder;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 at(random.uniform(-2, 2), random.uniform(0, 4), random.uniform(-2, 2));
        const float size = static_cast<float>(random.magnitude(-0.7, 0.2));
        builder.box(at, at + size * glm::vec3(1.0f, 0.8f, 1.2f));
    }
    return builder.scene();
}

/// A batch's casters, with a light or one that may be anywhere in its extent.
CullingCasters castersOf(const std::shared_ptr<const PlanePairShadow>& shadow, const Light& light) {
    CullingCasters casters;
    casters.shadow = shadow;
    casters.placed.casters = std::make_shared<const CasterEdges>(casterEdgesOf(*shadow));
    const LightBall ball = light.extent ? ballInObject(regionOf(light), glm::dmat4(1.0))
                                        : LightBall{glm::vec4(light.position), 0.0f};
    LightFacings(*shadow).find(ball, 23, casters.facings);
    return casters;
}

/// Whether the way from a point to the light meets the triangle.
bool isBlocked(const glm::dvec3& from, const glm::dvec4& light, const CapRecord& cap) {
    const glm::dvec3 way = glm::dvec3(light) - from * light.w;
    const glm::dvec3 a = glm::dvec3(cap.a) - from, b = glm::dvec3(cap.b) - from,
                     c = glm::dvec3(cap.c) - from;
    const double u = glm::dot(way, glm::cross(a, b)), v = glm::dot(way, glm::cross(b, c)),
                 w = glm::dot(way, glm::cross(c, a));
    if ((u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0)) return false;
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double share = glm::dot(a, normal) / glm::dot(way, normal);
    return share > 0.0 && (light.w == 0.0 || share < 1.0);
}

/// Some place that a light may be at.
glm::dvec4 placeWithin(const Light& region, Random& random) {
    glm::dvec3 arm;
    do
        arm = random.inCube();
    while (glm::length(arm) > 1.0);
    const LightShape shape = shapeOf(region);
    return shape.center + glm::dvec4(shape.arms * (arm / std::max(glm::length(arm), 0.3)), 0.0);
}

TEST(CasterCulling, RecordsOfWhatIsLeftAreClosed) {
    Random random(21);
    for (int i = 0; i < 60; ++i) {
        Scene scene = pile(random, 3);
        if (i % 2 == 0) { // open, and with edges of many triangles
            Geometry geometry = *scene.batches.front().geometry;
            for (int t = 0; t < 12; ++t)
                geometry.indices[static_cast<std::size_t>(
                    random.below(static_cast<int>(geometry.indices.size())))] = geometry.indices[0];
            scene.batches.front().geometry = CopyOnWrite<Geometry>(std::move(geometry));
        }
        const auto shadow = buildPlanePairs(scene, false).front();
        const CasterEdges edges = casterEdgesOf(*shadow);
        std::vector<std::uint8_t> gone(shadow->caps.size());
        for (std::uint8_t& cap : gone)
            cap = random.below(3) == 0;
        const PlanePairShadow kept = withoutCasters(*shadow, edges, gone);
        for (int l = 0; l < 6; ++l) {
            const glm::vec4 light(5.0 * random.inCube(), l % 2);
            EXPECT_EQ(test::openClusters(edges.mesh.positions, kept, light), 0u);
            for (std::size_t c = 0; c < gone.size(); ++c) {
                const int facing = test::facingOf(kept.caps[c], light, test::countAll);
                EXPECT_TRUE(gone[c] == 0 || facing == 0);
            }
        }
    }
}

TEST(CasterCulling, WhatIsLeftShadesAsMuch) {
    Random random(4);
    std::size_t left = 0, all = 0, asked = 0;
    for (int i = 0; i < 12; ++i) {
        const Scene scene = pile(random, 60);
        const auto shadow = buildPlanePairs(scene, false).front();
        const glm::dvec3 way = random.inCube();
        const Light light{i % 3 == 0   ? glm::dvec4(2.0 * way + glm::dvec3(0, 7, 0), 1)
                          : i % 3 == 1 ? glm::dvec4(2.0 * way, 1)
                                       : glm::dvec4(way.x, 0.3 + std::abs(way.y), way.z, 0)};
        const CullingCasters casters = castersOf(shadow, light);
        const auto gone = shadowedCasters(light, {casters}, {.size = 128}).front();
        all += gone.size();
        left += static_cast<std::size_t>(std::count(gone.begin(), gone.end(), 0));
        for (int p = 0; p < 3000; ++p) {
            const glm::dvec3 from = glm::dvec3(0, 2, 0) + 5.0 * random.inCube();
            bool blocked = false, blockedByKept = false;
            for (std::size_t c = 0; c < gone.size(); ++c) {
                if (casters.facings[c] <= 0 || !isBlocked(from, light.position, shadow->caps[c]))
                    continue;
                blocked = true;
                blockedByKept = blockedByKept || gone[c] == 0;
            }
            EXPECT_EQ(blockedByKept, blocked);
            asked += blocked;
        }
    }
    EXPECT_LT(left, all * 9 / 10);
    EXPECT_GT(asked, 3000u);
}

TEST(CasterCulling, WhatIsLeftShadesAsMuchWhereverTheLightIs) {
    Random random(5);
    std::size_t left = 0, all = 0, asked = 0;
    for (int i = 0; i < 16; ++i) {
        const Scene scene = pile(random, 60);
        const auto shadow = buildPlanePairs(scene, false).front();
        const glm::dvec3 way = random.inCube();
        const Light middle{i % 2 == 0 ? glm::dvec4(2.0 * way + glm::dvec3(0, 7, 0), 1)
                                      : glm::dvec4(way.x, 0.3 + std::abs(way.y), way.z, 0)};
        const Light region = anywhereWithin(middle, i % 2 == 0 ? 0.05 : glm::radians(0.5));
        const CullingCasters casters = castersOf(shadow, region);
        CullingSettings settings{.size = 128};
        settings.receivers.add({-5, -3, -5});
        settings.receivers.add({5, 7, 5});
        const auto gone = shadowedCasters(region, {casters}, settings).front();
        all += gone.size();
        left += static_cast<std::size_t>(std::count(gone.begin(), gone.end(), 0));
        for (int p = 0; p < 6000; ++p) {
            const glm::dvec3 from = glm::dvec3(0, 2, 0) + 5.0 * random.inCube();
            const glm::dvec4 light = placeWithin(region, random);
            bool blocked = false, blockedByKept = false;
            for (std::size_t c = 0; c < gone.size(); ++c) {
                const CapRecord& cap = shadow->caps[c];
                if (test::facingOf(cap, glm::vec4(light), test::countAll) <= 0 ||
                    !isBlocked(from, light, cap))
                    continue;
                blocked = true;
                blockedByKept = blockedByKept || gone[c] == 0;
            }
            EXPECT_EQ(blockedByKept, blocked) << i;
            asked += blocked;
        }
    }
    EXPECT_LT(left, all * 19 / 20);
    EXPECT_GT(asked, 3000u);
}

TEST(CasterCulling, NothingGoesThatNobodyWaitsFor) {
    Random random(6);
    const auto shadow = buildPlanePairs(pile(random, 60), false).front();
    const Light light{{0.2, 1, 0.1, 0}};
    CullingSettings settings{.size = 128};
    bool asked = false;
    settings.givenUp = [&] { return asked = true; };
    const auto gone = shadowedCasters(light, {castersOf(shadow, light)}, settings).front();
    EXPECT_TRUE(asked);
    EXPECT_EQ(std::count(gone.begin(), gone.end(), 1), 0);
}

TEST(LightRegion, HoldsWhatIsWithin) {
    const Light sun{{0, 2, 0, 0}}, lamp{{1, 1, 1, 1}};
    const Light near = sun.at({std::tan(0.009), 1, 0, 0}), far = sun.at({std::tan(0.011), 1, 0, 0});
    EXPECT_NEAR(placesApart(sun.position, near.position), 0.009, 1e-12);
    EXPECT_TRUE(isWithin(near, anywhereWithin(sun, 0.01), 1.0));
    EXPECT_FALSE(isWithin(near, anywhereWithin(sun, 0.01), 0.5));
    EXPECT_FALSE(isWithin(far, anywhereWithin(sun, 0.01), 1.0));
    EXPECT_TRUE(isWithin(lamp.at({1.05, 1, 1, 1}), anywhereWithin(lamp, 0.1), 1.0));
    EXPECT_FALSE(isWithin(lamp.at({1.15, 1, 1, 1}), anywhereWithin(lamp, 0.1), 1.0));
    EXPECT_FALSE(isWithin(lamp, anywhereWithin(sun, 0.1), 1.0));
    EXPECT_TRUE(isWithin(lamp, lamp, 0.0));
    EXPECT_FALSE(isWithin(near, sun, 1.0));
    Light shorter = lamp;
    shorter.range = 3.0;
    EXPECT_FALSE(isWithin(shorter, anywhereWithin(lamp, 0.1), 1.0));
}

} // namespace
} // namespace edgeshade
