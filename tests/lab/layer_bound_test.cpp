#include "src/shadow/layers/layer_search.hpp"
#include "tests/support/bounded_layers.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/scene_builder.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>
#include <random>

namespace edgeshade {
namespace {

using test::SceneBuilder;

Scene stack(int sheets) {
    SceneBuilder builder;
    for (int i = 0; i < sheets; ++i) {
        const float y = 0.01f * static_cast<float>(i);
        builder.quad({-1, y, 1}, {1, y, 1}, {1, y, -1}, {-1, y, -1});
    }
    return builder.scene();
}

LayerBound boundOf(const Scene& scene, const Light& light, std::size_t limit) {
    const auto records = buildPlanePairs(scene, false);
    return test::boundLayers({scene, records}, light, limit);
}

/// Number of each group's triangles on the line from the light through a point; for a sun, on the
/// whole line.
std::vector<std::size_t> trianglesMetByGroup(const Batch& batch, const Light& light,
                                             const glm::dvec3& through, const LayerBound& bound) {
    const bool sun = light.position.w == 0.0;
    const glm::dvec3 origin = sun ? through : glm::dvec3(light.position);
    const glm::dvec3 way = sun ? glm::dvec3(light.position) : through - origin;
    std::vector<std::size_t> met(bound.groupCount, 0);
    for (std::size_t i = 0; i < batch.geometry->indices.size(); i += 3) {
        const glm::dvec3 a(batch.geometry->positions[batch.geometry->indices[i]]);
        const glm::dvec3 ab =
            glm::dvec3(batch.geometry->positions[batch.geometry->indices[i + 1]]) - a;
        const glm::dvec3 ac =
            glm::dvec3(batch.geometry->positions[batch.geometry->indices[i + 2]]) - a;
        const glm::dvec3 across = glm::cross(way, ac);
        const double volume = glm::dot(ab, across);
        const double u = glm::dot(origin - a, across) / volume;
        const glm::dvec3 side = glm::cross(origin - a, ab);
        const double v = glm::dot(way, side) / volume;
        const std::size_t group = bound.groupOf.empty() ? 0 : bound.groupOf[i / 3];
        met[group] +=
            u >= 0.0 && v >= 0.0 && u + v <= 1.0 && (sun || glm::dot(ac, side) / volume > 0.0);
    }
    return met;
}

std::size_t sum(const std::vector<std::size_t>& counts) {
    return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

std::size_t most(const std::vector<std::size_t>& counts) {
    return *std::max_element(counts.begin(), counts.end());
}

TEST(LayerBound, FewTrianglesNeedNoGroups) {
    const LayerBound bound = boundOf(stack(100), test::pointLight({0, 9, 0}), 255);
    EXPECT_EQ(bound.groupCount, 1u);
    EXPECT_LE(bound.most, 255u);
}

TEST(LayerBound, IsNeverBelowTheTruth) {
    // A line from straight above meets one triangle of every sheet; along the diagonal two.
    for (const Light& light : {test::pointLight({0.3, 9, 0.1}), test::sun({0.1, 1, 0.2})}) {
        const LayerBound bound = boundOf(stack(300), light, 255);
        EXPECT_GE(bound.most, 300u);
        EXPECT_GT(bound.groupCount, 1u);
        EXPECT_EQ(bound.groupOf.size(), 600u);
        EXPECT_GE(sum(trianglesMetByGroup(stack(300).batches.front(), light, {0.2, 0, 0.1}, bound)),
                  300u);
    }
}

// 256 triangles of one group over one pixel would look lit.
TEST(LayerBound, OneGroupHasNoMoreLayersThanTheLimit) {
    for (const int sheets : {256, 511}) {
        const Scene scene = stack(sheets);
        for (const Light& light : {test::pointLight({0.3, 9, 0.1}), test::sun({0.01, 1, 0.02})}) {
            const LayerBound bound = boundOf(scene, light, 255);
            const auto met =
                trianglesMetByGroup(scene.batches.front(), light, {0.2, 0, 0.1}, bound);
            EXPECT_EQ(sum(met), static_cast<std::size_t>(sheets));
            EXPECT_LE(most(met), 255u) << sheets << " sheets";
        }
    }
}

TEST(LayerBound, SheetsSideBySideAreNoLayers) {
    SceneBuilder builder;
    for (int i = 0; i < 400; ++i) {
        const float x = static_cast<float>(i);
        builder.triangle({x, 0, 0}, {x + 0.9f, 0, 0}, {x, 0, 1});
    }
    for (const Light& light : {test::pointLight({200, 50, 0.1}), test::sun({0.1, 1, 0.2})})
        EXPECT_EQ(boundOf(builder.scene(), light, 255).groupCount, 1u);
}

TEST(LayerBound, ALightAmongTheTrianglesIsBoundedToo) {
    const LayerBound bound = boundOf(stack(1000), test::pointLight({0.2, 5.005, 0.1}), 255);
    EXPECT_GE(bound.most, 500u);
    EXPECT_GE(bound.groupCount, 2u);
}

TEST(LayerBound, MoreGroupsThanAreWorthItAreNone) {
    const Light light = test::sun({0, 1, 0});
    const LayerBound many = boundOf(stack(1500), light, 50);
    EXPECT_GE(many.groupCount, 30u);
    EXPECT_FALSE(many.mayOverflow);
    const LayerBound tooMany = boundOf(stack(6000), light, 50);
    EXPECT_TRUE(tooMany.mayOverflow);
    EXPECT_EQ(tooMany.groupCount, 1u);
    EXPECT_TRUE(tooMany.groupOf.empty());
    EXPECT_GE(tooMany.most, 6000u);
}

TEST(LayerBound, NoLineMeetsMoreTrianglesThanItSays) {
    // All around the lamp, so that many triangles lie on two or three faces of its cube.
    std::mt19937 random(7);
    std::uniform_real_distribution<float> around(-3.0f, 3.0f), near(-0.6f, 0.6f);
    const auto vector = [&](auto& numbers) {
        const float x = numbers(random), y = numbers(random), z = numbers(random);
        return glm::vec3(x, y, z);
    };
    SceneBuilder builder;
    for (int i = 0; i < 1500; ++i) {
        const glm::vec3 middle = vector(around);
        const float size = i % 50 == 0 ? 8.0f : 1.0f;
        builder.triangle(middle, middle + size * vector(near), middle + size * vector(near));
    }
    const Scene scene = builder.scene();
    const Batch& batch = scene.batches.front();
    const auto records = buildPlanePairs(scene, false);
    for (const Light& light : {test::pointLight({0.1, 0.2, 0.05}), test::pointLight({9, 4, 2}),
                               test::sun({0.3, 1, 0.2})}) {
        // Only the grid, then closer looks where it is too coarse, then groups.
        for (const std::size_t limit : {1000u, 20u, 5u}) {
            for (const LayerBound& bound :
                 {test::boundLayers({scene, records}, light, limit),
                  boundByTriangles(scene, false, std::span(&light, 1), limit)}) {
                std::size_t mostMet = 0, mostOfOneGroup = 0;
                for (int i = 0; i < 3000; ++i) {
                    const auto met =
                        trianglesMetByGroup(batch, light, glm::dvec3(vector(around)), bound);
                    mostMet = std::max(mostMet, sum(met));
                    mostOfOneGroup = std::max(mostOfOneGroup, most(met));
                }
                EXPECT_LE(mostMet, bound.most);
                EXPECT_GE(mostMet, 6u) << "the lines should meet something";
                if (!bound.mayOverflow) {
                    EXPECT_LE(mostOfOneGroup, limit);
                }
                EXPECT_LT(bound.most, batch.geometry->indices.size() / 3);
            }
        }
    }
}

} // namespace
} // namespace edgeshade
