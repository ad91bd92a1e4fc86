#include "preprocess/mesh/edges.hpp"

#include "tests/support/tiny_meshes.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <tuple>

namespace edgeshade::test {
namespace {

/// Edges as (a, b, n).
std::vector<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> listed(const EdgeList& list) {
    std::vector<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> result;
    for (const Edge& edge : list.edges)
        result.emplace_back(edge.a, edge.b, edge.oppositeCount);
    return result;
}

std::vector<std::uint32_t> oppositeVertices(const EdgeList& list, std::size_t edge) {
    std::vector<std::uint32_t> vertices;
    for (const Opposite& opposite : list.oppositesOf(list.edges[edge]))
        vertices.push_back(opposite.vertex);
    return vertices;
}

} // namespace

TEST(Edges, NoTrianglesHaveNone) {
    const EdgeList list = build({}).edges;
    EXPECT_TRUE(list.edges.empty());
    EXPECT_EQ(list.largestOppositeCount(), 0u);
}

TEST(Edges, ATriangleHasThreeWithOneOppositeEach) {
    const EdgeList list = build({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2}}).edges;
    using Edges = std::vector<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>>;
    EXPECT_EQ(listed(list), (Edges{{0, 1, 1}, {0, 2, 1}, {1, 2, 1}}));
    EXPECT_EQ(oppositeVertices(list, 0), (std::vector<std::uint32_t>{2}));
    EXPECT_EQ(oppositeVertices(list, 1), (std::vector<std::uint32_t>{1}));
    EXPECT_EQ(oppositeVertices(list, 2), (std::vector<std::uint32_t>{0}));
}

TEST(Edges, ASharedOneHasBothOpposites) {
    //   1---3
    //   |\  |     0 (0,0)  1 (0,1)  2 (1,0)  3 (1,1)
    //   | \ |
    //   0---2
    const EdgeList list =
        build({{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}}, {0, 2, 1, 1, 2, 3}}).edges;
    using Edges = std::vector<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>>;
    EXPECT_EQ(listed(list), (Edges{{0, 1, 1}, {0, 2, 1}, {1, 2, 2}, {1, 3, 1}, {2, 3, 1}}));
    EXPECT_EQ(oppositeVertices(list, 2), (std::vector<std::uint32_t>{0, 3}));
}

TEST(Edges, SmallerVertexFirstAndSorted) {
    for (const Soup& soup : {cube(), fin(), fan(128), moebiusStrip(), tJunction()}) {
        const EdgeList list = build(soup).edges;
        for (const Edge& edge : list.edges)
            EXPECT_LT(edge.a, edge.b);
        EXPECT_TRUE(
            std::is_sorted(list.edges.begin(), list.edges.end(), [](const Edge& x, const Edge& y) {
                return std::tie(x.a, x.b) < std::tie(y.a, y.b);
            }));
    }
}

TEST(Edges, EveryTriangleIsOppositeOnThree) {
    for (const Soup& soup : {cube(), fin(), fan(128), moebiusStrip(), tJunction()}) {
        const Built built = build(soup);
        std::vector<int> seen(built.mesh.triangles.size(), 0);
        for (const Edge& edge : built.edges.edges)
            for (const Opposite& opposite : built.edges.oppositesOf(edge)) {
                ++seen[opposite.triangle];
                Triangle expected = {edge.a, edge.b, opposite.vertex};
                Triangle triangle = built.mesh.triangles[opposite.triangle];
                std::sort(expected.begin(), expected.end());
                std::sort(triangle.begin(), triangle.end());
                EXPECT_EQ(triangle, expected);
            }
        EXPECT_EQ(seen, std::vector<int>(seen.size(), 3));
    }
}

TEST(Edges, AFanOf128HasASpineWith128Opposites) {
    const EdgeList list = build(fan(128)).edges;
    EXPECT_EQ(list.edges.size(), 257u);
    EXPECT_EQ(list.largestOppositeCount(), 128u);
    EXPECT_EQ(list.edges.front().oppositeCount, 128u);
}

TEST(Edges, DuplicateTrianglesCountTwice) {
    const EdgeList list = build({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2, 2, 1, 0}}).edges;
    EXPECT_EQ(list.edges.size(), 3u);
    for (std::size_t e = 0; e < 3; ++e)
        EXPECT_EQ(list.edges[e].oppositeCount, 2u);
    EXPECT_EQ(oppositeVertices(list, 0), (std::vector<std::uint32_t>{2, 2}));
}

} // namespace edgeshade::test
