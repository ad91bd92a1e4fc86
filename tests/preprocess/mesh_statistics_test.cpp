#include "preprocess/mesh/mesh_statistics.hpp"

#include "tests/support/small_soups.hpp"

#include <algorithm>
#include <cstdlib>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace edgeshade::test {
namespace {

using ByCount = std::map<std::uint32_t, std::size_t>;

MeshStatistics statisticsOf(const Soup& soup) {
    const Built built = build(soup);
    return meshStatistics(built.mesh, built.edges);
}

Soup triangleTwice(bool sameWinding) {
    Soup soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2, 0, 1, 2}};
    if (!sameWinding) std::swap(soup.indices[4], soup.indices[5]);
    return soup;
}

/// 1 if the triangle runs from `a` to `b`, -1 if back, 0 if neither or both.
int runs(const Triangle& triangle, std::uint32_t a, std::uint32_t b) {
    int sum = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        const std::uint32_t from = triangle[c], to = triangle[(c + 1) % 3];
        sum += (from == a && to == b) - (from == b && to == a);
    }
    return sum;
}

/// Components and closed triangles computed without edges or sets: labels spread until none
/// changes, and the balance of every pair of vertices is checked.
std::pair<std::size_t, std::size_t> bySpreading(const WeldedMesh& mesh) {
    const auto& triangles = mesh.triangles;
    std::vector<std::size_t> label(triangles.size());
    for (std::size_t t = 0; t < label.size(); ++t)
        label[t] = t;
    const auto shareAnEdge = [&](const Triangle& s, const Triangle& t) {
        return std::count_if(s.begin(), s.end(), [&](std::uint32_t vertex) {
                   return std::find(t.begin(), t.end(), vertex) != t.end();
               }) >= 2;
    };
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t s = 0; s < label.size(); ++s)
            for (std::size_t t = 0; t < label.size(); ++t)
                if (label[s] < label[t] && shareAnEdge(triangles[s], triangles[t])) {
                    label[t] = label[s];
                    changed = true;
                }
    }
    std::vector<bool> open(label.size(), false);
    for (std::uint32_t a = 0; a < mesh.positions.size(); ++a)
        for (std::uint32_t b = a + 1; b < mesh.positions.size(); ++b) {
            int balance = 0;
            for (const Triangle& triangle : triangles)
                balance += runs(triangle, a, b);
            for (std::size_t t = 0; t < label.size(); ++t)
                if (balance != 0 && runs(triangles[t], a, b) != 0) open[label[t]] = true;
        }
    std::size_t components = 0, closed = 0;
    for (std::size_t t = 0; t < label.size(); ++t) {
        components += label[t] == t;
        closed += !open[label[t]];
    }
    return {components, closed};
}

} // namespace

TEST(MeshStatistics, NothingHasNothing) {
    const MeshStatistics statistics = statisticsOf({});
    EXPECT_EQ(statistics.triangles, 0u);
    EXPECT_EQ(statistics.edges, 0u);
    EXPECT_EQ(statistics.components, 0u);
    EXPECT_EQ(statistics.largestOppositeCount(), 0u);
}

TEST(MeshStatistics, ACubeIsOneClosedComponent) {
    // 12 edges of the cube and 6 diagonals.
    const MeshStatistics statistics = statisticsOf(cube());
    EXPECT_EQ(statistics.triangles, 12u);
    EXPECT_EQ(statistics.edges, 18u);
    EXPECT_EQ(statistics.edgesByOppositeCount, (ByCount{{2, 18}}));
    EXPECT_EQ(statistics.components, 1u);
    EXPECT_EQ(statistics.closedOrientedTriangles, 12u);
}

TEST(MeshStatistics, OneTurnedTriangleUnorientsItsComponent) {
    Soup turned = cube();
    std::swap(turned.indices[0], turned.indices[1]);
    const MeshStatistics statistics = statisticsOf(turned);
    EXPECT_EQ(statistics.edgesByOppositeCount, (ByCount{{2, 18}}));
    EXPECT_EQ(statistics.closedOrientedTriangles, 0u);
}

TEST(MeshStatistics, ACubeInsideOutIsClosedToo) {
    Soup inverted = cube();
    for (std::size_t i = 0; i < inverted.indices.size(); i += 3)
        std::swap(inverted.indices[i], inverted.indices[i + 1]);
    EXPECT_EQ(statisticsOf(inverted).closedOrientedTriangles, 12u);
}

TEST(MeshStatistics, AnOpenBoxIsNotClosed) {
    // The rim's 4 edges have one triangle; 8 other edges and 5 diagonals have two.
    const MeshStatistics statistics = statisticsOf(openBox());
    EXPECT_EQ(statistics.triangles, 10u);
    EXPECT_EQ(statistics.edgesByOppositeCount, (ByCount{{1, 4}, {2, 13}}));
    EXPECT_EQ(statistics.components, 1u);
    EXPECT_EQ(statistics.closedOrientedTriangles, 0u);
}

TEST(MeshStatistics, AFinHasASpineOfThree) {
    const MeshStatistics statistics = statisticsOf(fin());
    EXPECT_EQ(statistics.edgesByOppositeCount, (ByCount{{1, 6}, {3, 1}}));
    EXPECT_EQ(statistics.largestOppositeCount(), 3u);
    EXPECT_EQ(statistics.components, 1u);
    EXPECT_EQ(statistics.closedOrientedTriangles, 0u);
}

TEST(MeshStatistics, AFanHasASpineOfAll) {
    const MeshStatistics statistics = statisticsOf(fan(128));
    EXPECT_EQ(statistics.edgesByOppositeCount, (ByCount{{1, 256}, {128, 1}}));
    EXPECT_EQ(statistics.components, 1u);
}

TEST(MeshStatistics, AMoebiusStripIsOneOpenComponent) {
    // The ten edges of five vertices: (i, i+1) lies between two triangles, (i, i+2) on the border.
    const MeshStatistics statistics = statisticsOf(moebiusStrip());
    EXPECT_EQ(statistics.edgesByOppositeCount, (ByCount{{1, 5}, {2, 5}}));
    EXPECT_EQ(statistics.components, 1u);
    EXPECT_EQ(statistics.closedOrientedTriangles, 0u);
}

TEST(MeshStatistics, ATriangleAndItsBackAreClosed) {
    const MeshStatistics statistics = statisticsOf(triangleTwice(false));
    EXPECT_EQ(statistics.edgesByOppositeCount, (ByCount{{2, 3}}));
    EXPECT_EQ(statistics.components, 1u);
    EXPECT_EQ(statistics.closedOrientedTriangles, 2u);
}

TEST(MeshStatistics, ATriangleTwiceTheSameWayIsNotOriented) {
    const MeshStatistics statistics = statisticsOf(triangleTwice(true));
    EXPECT_EQ(statistics.edgesByOppositeCount, (ByCount{{2, 3}}));
    EXPECT_EQ(statistics.closedOrientedTriangles, 0u);
}

TEST(MeshStatistics, ATJunctionConnectsNothing) {
    // A-C below is no edge of the triangles above, which have A-M and M-C; only M-E is shared.
    const MeshStatistics statistics = statisticsOf(tJunction());
    EXPECT_EQ(statistics.edgesByOppositeCount, (ByCount{{1, 7}, {2, 1}}));
    EXPECT_EQ(statistics.components, 2u);
    EXPECT_EQ(statistics.closedOrientedTriangles, 0u);
}

TEST(MeshStatistics, CubesThatShareAnEdgeAreClosed) {
    //       +---+
    //       |   |     from above: two triangles of each cube on the edge that they share, one in
    //   +---+---+     either direction
    //   |   |
    //   +---+
    Soup soup = cube();
    for (const glm::vec3& p : cube().positions)
        soup.positions.push_back(p + glm::vec3(1, 1, 0));
    for (const std::uint32_t index : cube().indices)
        soup.indices.push_back(index + 8);
    const MeshStatistics statistics = statisticsOf(soup);
    EXPECT_EQ(statistics.edgesByOppositeCount, (ByCount{{2, 34}, {4, 1}}));
    EXPECT_EQ(statistics.components, 1u);
    EXPECT_EQ(statistics.closedOrientedTriangles, 24u);
    // With one of them inside out it is still a closed chain; with one triangle reversed it is not.
    for (std::size_t i = 36; i < 72; i += 3)
        std::swap(soup.indices[i], soup.indices[i + 1]);
    EXPECT_EQ(statisticsOf(soup).closedOrientedTriangles, 24u);
    std::swap(soup.indices[36], soup.indices[37]);
    EXPECT_EQ(statisticsOf(soup).closedOrientedTriangles, 0u);
}

TEST(MeshStatistics, VerticesAloneDoNotConnect) {
    //   1   3
    //   |\ /|
    //   | X |     two triangles that meet in the vertex X
    //   |/ \|
    //   0   2
    const MeshStatistics statistics =
        statisticsOf({{{0, 0, 0}, {0, 2, 0}, {2, 0, 0}, {2, 2, 0}, {1, 1, 0}}, {0, 4, 1, 2, 3, 4}});
    EXPECT_EQ(statistics.components, 2u);
}

TEST(MeshStatistics, OnlyClosedComponentsCountAsClosed) {
    // The cube, a triangle far away, and a degenerate one.
    Soup soup = cube();
    soup.positions.insert(soup.positions.end(), {{9, 0, 0}, {9, 1, 0}, {9, 0, 1}});
    soup.indices.insert(soup.indices.end(), {8, 9, 10, 8, 8, 9});
    const MeshStatistics statistics = statisticsOf(soup);
    EXPECT_EQ(statistics.triangles, 13u);
    EXPECT_EQ(statistics.degenerateTriangles, 1u);
    EXPECT_EQ(statistics.components, 2u);
    EXPECT_EQ(statistics.closedOrientedTriangles, 12u);
}

RC_GTEST_PROP(MeshStatistics, ComponentsAreThoseFoundBySpreading, ()) {
    Soup soup = latticeSoup();
    // In half of the cases every triangle also has its back, so that closed components occur.
    if (*rc::gen::arbitrary<bool>())
        for (std::size_t i = soup.indices.size(); i-- > 0;)
            soup.indices.push_back(soup.indices[i]);
    const Built built = build(soup);
    const MeshStatistics statistics = meshStatistics(built.mesh, built.edges);
    const auto [components, closed] = bySpreading(built.mesh);
    RC_ASSERT(statistics.components == components);
    RC_ASSERT(statistics.closedOrientedTriangles == closed);
}

TEST(MeshStatistics, SumsAdd) {
    MeshStatistics sum = statisticsOf(cube());
    sum += statisticsOf(fin());
    EXPECT_EQ(sum.triangles, 15u);
    EXPECT_EQ(sum.edges, 25u);
    EXPECT_EQ(sum.edgesByOppositeCount, (ByCount{{1, 6}, {2, 18}, {3, 1}}));
    EXPECT_EQ(sum.components, 2u);
    EXPECT_EQ(sum.closedOrientedTriangles, 12u);
}

} // namespace edgeshade::test
