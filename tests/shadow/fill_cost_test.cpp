// The estimated cost of filling, without a GL.
#include "src/shadow/plan/volume_fill.hpp"
#include "tests/support/bounded_frame.hpp"
#include "tests/support/hard_lights.hpp"
#include "tests/support/placed_shadows.hpp"
#include "tests/support/scene_builder.hpp"

#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::Random;

constexpr int side = 1024;
constexpr PixelRectangle whole{0, 0, side, side};

using Corners = std::array<glm::dvec2, 3>; ///< in pixels

FillCost costOf(const Corners& corners, const PixelRectangle& open = whole) {
    std::array<glm::dvec4, 3> clip;
    for (std::size_t i = 0; i < 3; ++i)
        clip[i] = glm::dvec4(2.0 * corners[i] / static_cast<double>(side) - 1.0, 0.0, 1.0);
    return FillMeter(glm::dmat4(1.0), side, side, open).of(clip);
}

/// Whether the triangle meets a square: no line separates them.
bool meets(const Corners& triangle, const glm::dvec2& low, double size) {
    const std::array<glm::dvec2, 4> square = {
        {low, low + glm::dvec2(size, 0), low + glm::dvec2(0, size), low + glm::dvec2(size)}};
    std::vector<glm::dvec2> axes = {{1, 0}, {0, 1}};
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec2 edge = triangle[(i + 1) % 3] - triangle[i];
        axes.emplace_back(-edge.y, edge.x);
    }
    for (const glm::dvec2& axis : axes) {
        double lowest = 1e30, highest = -1e30, squareLow = 1e30, squareHigh = -1e30;
        for (const glm::dvec2& p : triangle) {
            lowest = std::min(lowest, glm::dot(axis, p));
            highest = std::max(highest, glm::dot(axis, p));
        }
        for (const glm::dvec2& p : square) {
            squareLow = std::min(squareLow, glm::dot(axis, p));
            squareHigh = std::max(squareHigh, glm::dot(axis, p));
        }
        if (highest < squareLow || squareHigh < lowest) return false;
    }
    return true;
}

double cellsOf(const Corners& triangle, int size) {
    double cells = 0.0;
    for (int y = 0; y < side; y += size)
        for (int x = 0; x < side; x += size)
            cells += meets(triangle, glm::dvec2(x, y), size) ? 1.0 : 0.0;
    return cells;
}

TEST(FillCost, TilesAndBlocksAreRightOnTheAverage) {
    Random random(5);
    double tiles = 0.0, estimatedTiles = 0.0, blocks = 0.0, estimatedBlocks = 0.0;
    for (int i = 0; i < 60; ++i) {
        const double size = random.magnitude(0.5, 2.3);
        const glm::dvec2 middle(random.uniform(300, 700), random.uniform(300, 700));
        Corners corners;
        for (glm::dvec2& corner : corners)
            corner = middle + size * glm::dvec2(random.inCube());
        const FillCost cost = costOf(corners);
        estimatedTiles += cost.tilePairs;
        estimatedBlocks += cost.blocks;
        tiles += cellsOf(corners, 64);
        blocks += cellsOf(corners, 4);
    }
    EXPECT_NEAR(estimatedTiles, tiles, 0.05 * tiles);
    EXPECT_NEAR(estimatedBlocks, blocks, 0.02 * blocks);
}

TEST(FillCost, FragmentsAreTheAreaThatMayBeDrawn) {
    const Corners corners = {{{100, 100}, {300, 100}, {100, 300}}};
    EXPECT_NEAR(costOf(corners).fragments, 20000.0, 1e-6);
    EXPECT_NEAR(costOf(corners, {100, 100, 100, 100}).fragments, 10000.0, 1e-6);
    EXPECT_EQ(costOf(corners, {500, 500, 100, 100}).tilePairs, 0.0);
    EXPECT_EQ(costOf({{{-300, 10}, {-100, 10}, {-200, 90}}}).triangles, 0.0);
}

TEST(FillCost, WhatIsBeforeTheNearPlaneTakesNothing) {
    const FillMeter meter(glm::dmat4(1.0), side, side, whole);
    const std::array<glm::dvec4, 3> before = {
        {{-0.5, -0.5, -1.5, 1}, {0.5, -0.5, -1.5, 1}, {0, 0.5, -1.5, 1}}};
    EXPECT_EQ(meter.of(before).fragments, 0.0);
    EXPECT_GT(meter.of(before, false).fragments, 0.0);
}

/// A plan of one light over a scene.
struct Planned {
    FrameView view;
    PotentialSilhouettes silhouettes{23};
    CountPlan plan;
    FillCost fill;

    Planned(const Scene& scene, const Camera& camera, const Light& light)
        : view(test::boundedFrame(scene, false,
                                  {frustumOf(camera, 1.0), side, side, {light}, {0.1, 1}})) {
        PlanSettings settings;
        settings.silhouettes = &silhouettes;
        silhouettes.beginFrame(nullptr);
        planCount(test::placedShadows(scene), scene.materials, view, view.slices.front(), 0,
                  settings, plan);
        fill = fillOf(plan, view, view.slices.front(), whole);
    }
};

const Camera fromAbove{{9, 6, 8}, {0, 0.5, 0}, 50.0};

/// Scattered boxes over a floor.
Scene boxes(int count) {
    Random random(9);
    test::SceneBuilder builder;
    builder.floor(30);
    for (int i = 0; i < count; ++i) {
        const glm::dvec3 at(random.uniform(-6, 6), random.uniform(0.2, 2), random.uniform(-6, 6));
        builder.box(glm::vec3(at), glm::vec3(at) + glm::vec3(0.5f, 0.7f, 0.4f));
    }
    return builder.scene();
}

TEST(VolumeFill, SidesOfABoxUnderASun) {
    const Scene scene = test::SceneBuilder().box({-1, 1, -1}, {1, 2, 1}).scene();
    const Camera aside{{0, 3, 9}, {0, 1, 0}, 50.0};
    const Light sun{{0.2, 1, 0.1, 0}};
    // Six edges are the box's silhouette, and each side is two triangles that end at a plane.
    EXPECT_EQ(Planned(scene, aside, sun).fill.triangles, 2 * 6);
}

TEST(VolumeEnds, AreAtPlanesThatSuit) {
    Random random(11);
    int ends = 0;
    for (int i = 0; i < 40; ++i) {
        const Light lamp{glm::dvec4(6.0 * random.inCube() + glm::dvec3(0, 2, 0), 1)};
        const Scene scene = boxes(200);
        const Planned planned(scene, fromAbove, lamp);
        const PlanView view =
            planView(planned.view, planned.view.slices.front(), lamp, glm::dmat4(1.0));
        const BatchPlan& batch = planned.plan.batches.front();
        for (const ClusterPlan& draw : batch.volumes.drawn)
            for (std::uint32_t c = draw.clusters.first; c < draw.clusters.end(); ++c) {
                if (draw.end < 0) continue;
                ++ends;
                EXPECT_FALSE(draw.zFail());
                EXPECT_TRUE(mayEndAt(batch.shadow->clusters[c].bounds, view,
                                     static_cast<std::size_t>(draw.end)));
            }
    }
    EXPECT_GE(ends, 40);
}

} // namespace
} // namespace edgeshade
