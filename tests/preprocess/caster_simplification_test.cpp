#include "preprocess/mesh/caster_simplification.hpp"

#include "preprocess/mesh/mesh_statistics.hpp"
#include "preprocess/mesh/topology.hpp"
#include "tests/support/hard_lights.hpp"
#include "tests/support/plane_pair_chain.hpp"
#include "tests/support/scene_builder.hpp"
#include "tests/support/small_soups.hpp"

#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::SceneBuilder;

/// The point at a row and a column of a ball of radius 1.
glm::vec3 onBall(int row, int column, int rows, int columns) {
    if (row == 0 || row == rows) return {0.0f, row == 0 ? 1.0f : -1.0f, 0.0f};
    const double v = std::numbers::pi * row / rows;
    const double u = 2.0 * std::numbers::pi * (column % columns) / columns;
    return glm::vec3(glm::dvec3(std::sin(v) * std::cos(u), std::cos(v), std::sin(v) * std::sin(u)));
}

/// A closed ball, wound outwards, and under it a floor of 16 x 16 cells.
SceneBuilder ballOverFloor() {
    constexpr int rows = 24, columns = 48, cells = 16;
    SceneBuilder builder;
    const auto ball = [](int row, int column) { return onBall(row, column, rows, columns); };
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const glm::vec3 a = ball(row, column), b = ball(row + 1, column),
                            c = ball(row + 1, column + 1), d = ball(row, column + 1);
            if (row > 0) builder.triangle(a, d, b);
            if (row + 1 < rows) builder.triangle(d, c, b);
        }
    const auto floor = [](int x, int z) { return glm::vec3(x - 8, -2.0f, z - 8); };
    for (int x = 0; x < cells; ++x)
        for (int z = 0; z < cells; ++z)
            builder.quad(floor(x, z), floor(x, z + 1), floor(x + 1, z + 1), floor(x + 1, z));
    return builder;
}

CasterMesh castersIn(const Scene& scene, bool castMasked = false) {
    const Batch& batch = scene.batches.front();
    return weldCasters(batch, castersOf(batch, scene.materials, castMasked));
}

MeshStatistics statisticsOf(const CasterMesh& mesh) {
    return meshStatistics(mesh.welded, buildEdges(mesh.welded));
}

std::size_t trianglesWith(const Scene& scene, double error) {
    Scene simplified = scene;
    simplifyCasters(simplified, error);
    return castersIn(simplified).welded.triangles.size();
}

/// A scene from a soup, including triangles without area.
Scene sceneFrom(const test::Soup& soup) {
    SceneBuilder builder;
    for (std::size_t i = 0; i + 2 < soup.indices.size(); i += 3)
        builder.triangle(soup.positions[soup.indices[i]], soup.positions[soup.indices[i + 1]],
                         soup.positions[soup.indices[i + 2]]);
    return builder.scene();
}

} // namespace

TEST(CasterSimplification, NoErrorLeavesCastersAlone) {
    Scene scene = ballOverFloor().scene();
    simplifyCasters(scene, 0.0);
    EXPECT_FALSE(scene.batches.front().geometry->simplifiedCasters);
    EXPECT_EQ(castersIn(scene).welded.triangles.size(), scene.triangleCount());
}

TEST(CasterSimplification, SurfacesStayAsTheyAre) {
    const Scene before = ballOverFloor().scene();
    Scene after = before;
    simplifyCasters(after, 0.1);
    const Batch &a = before.batches.front(), &b = after.batches.front();
    EXPECT_EQ(a.geometry->positions, b.geometry->positions);
    EXPECT_EQ(a.geometry->indices, b.geometry->indices);
    EXPECT_EQ(positionsHash(a, castingSurfacesOf(*a.geometry, before.materials, false)),
              positionsHash(b, castingSurfacesOf(*b.geometry, after.materials, false)));
}

TEST(CasterSimplification, ALargerErrorLeavesFewerTriangles) {
    const Scene scene = ballOverFloor().scene();
    std::size_t last = scene.triangleCount();
    for (const double error : {0.001, 0.01, 0.05, 0.2}) {
        const std::size_t triangles = trianglesWith(scene, error);
        EXPECT_LT(triangles, last) << error;
        last = triangles;
    }
    EXPECT_LT(last, scene.triangleCount() / 20);
    EXPECT_GT(last, 0u);
}

TEST(CasterSimplification, WhatIsFlatGoesAtOnce) {
    // 512 triangles of the floor become 2; the ball has 2,208.
    EXPECT_LE(trianglesWith(ballOverFloor().scene(), 1e-6), 2208u + 2u);
}

TEST(CasterSimplification, WhatWasClosedStaysClosed) {
    Scene scene = ballOverFloor().scene();
    const std::size_t closed = statisticsOf(castersIn(scene)).closedOrientedTriangles;
    ASSERT_EQ(closed, 2208u);
    simplifyCasters(scene, 0.02);
    const MeshStatistics simplified = statisticsOf(castersIn(scene));
    EXPECT_GT(simplified.closedOrientedTriangles, 0u);
    EXPECT_LT(simplified.closedOrientedTriangles, closed / 2);
    EXPECT_EQ(simplified.triangles - simplified.closedOrientedTriangles, 2u); // the floor
}

TEST(CasterSimplification, PointsStayWithinAFewErrorsOfTheBall) {
    for (const double error : {0.005, 0.02, 0.08}) {
        Scene scene = ballOverFloor().scene();
        simplifyCasters(scene, error);
        double farthest = 0.0;
        const CasterMesh mesh = castersIn(scene);
        for (const Triangle& triangle : mesh.welded.triangles) {
            glm::dvec3 middle(0.0);
            for (const std::uint32_t corner : triangle)
                middle += glm::dvec3(mesh.welded.positions[corner]) / 3.0;
            if (middle.y > -1.5) farthest = std::max(farthest, 1.0 - glm::length(middle));
        }
        EXPECT_LT(farthest, 4.0 * error);
    }
}

TEST(CasterSimplification, TheErrorIsThatOfTheWorld) {
    const Scene scene = ballOverFloor().scene();
    const glm::dmat4 large = glm::dmat4(glm::dmat3(100.0));
    EXPECT_EQ(trianglesWith(ballOverFloor().placedBy(large).scene(), 1.0),
              trianglesWith(scene, 0.01));
}

TEST(CasterSimplification, CastersThatAreNotOpaqueStayAsTheyAre) {
    Material mask;
    mask.alphaMode = AlphaMode::mask;
    SceneBuilder builder = ballOverFloor();
    builder.material(mask).quad({0, 3, 0}, {1, 3, 0}, {1, 3, 1}, {0, 3, 1});
    Scene scene = builder.scene();
    simplifyCasters(scene, 0.05);
    const CasterMesh opaque = castersIn(scene), all = castersIn(scene, true);
    EXPECT_EQ(all.welded.triangles.size(), opaque.welded.triangles.size() + 2);
    ASSERT_EQ(all.groups.size(), 2u);
    EXPECT_EQ(all.groups.back().capCount, 2u);
    EXPECT_EQ(scene.materials[all.groups.back().material].alphaMode, AlphaMode::mask);
}

TEST(CasterSimplification, ASceneWhereNothingCastsHasNoCasters) {
    Material blend;
    blend.alphaMode = AlphaMode::blend;
    SceneBuilder builder;
    builder.material(blend).floor(1.0f);
    Scene scene = builder.scene();
    simplifyCasters(scene, 1.0);
    EXPECT_TRUE(castersIn(scene).welded.triangles.empty());
}

TEST(CasterSimplification, ChainsOfRandomSoupsStayClosed) {
    test::Random random(17);
    std::size_t fewer = 0;
    for (std::size_t i = 0; i < 2000; ++i) {
        const test::Soup soup = test::randomSoup(random, 1 + random.below(24));
        Scene scene = sceneFrom(soup);
        const CasterMesh before = castersIn(scene);
        if (before.welded.triangles.empty()) continue;
        const auto& points = before.welded.positions;
        simplifyCasters(scene, 0.1 * glm::distance(points.front(), points.back()));
        const CasterMesh mesh = castersIn(scene);
        fewer += mesh.welded.triangles.size() < before.welded.triangles.size();
        if (mesh.welded.triangles.empty()) continue;
        const PlanePairShadow shadow =
            buildPlanePairs(mesh, buildEdges(mesh.welded), scene.materials);
        const CapRecord& cap = shadow.caps.front();
        const glm::vec4 light = test::randomLight(
            random, {cap.a, cap.b, cap.c}, static_cast<test::LightKind>(i % test::lightKindCount));
        ASSERT_EQ(test::openClusters(mesh.welded.positions, shadow, light), 0u) << i;
    }
    EXPECT_GT(fewer, 100u);
}

} // namespace edgeshade
