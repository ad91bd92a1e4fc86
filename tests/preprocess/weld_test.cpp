#include "preprocess/mesh/weld.hpp"

#include "tests/support/tiny_meshes.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

using Indices = std::vector<std::uint32_t>;

WeldedMesh welded(const Soup& soup) {
    return weld(soup.positions, soup.indices);
}

} // namespace

TEST(Weld, NothingGivesNothing) {
    const WeldedMesh mesh = welded({});
    EXPECT_TRUE(mesh.positions.empty());
    EXPECT_TRUE(mesh.triangles.empty());
    EXPECT_EQ(mesh.degenerate, 0u);
}

TEST(Weld, PositionsAreDistinctAndAscending) {
    // The corners of two triangles over the square, each with its own vertices.
    const WeldedMesh mesh = welded(
        {{{1, 1, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}}, {0, 1, 2, 3, 4, 5}});
    EXPECT_EQ(mesh.positions, (std::vector<glm::vec3>{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}}));
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{3, 0, 2}, {3, 1, 0}}));
}

TEST(Weld, OrderIsLexicographic) {
    EXPECT_TRUE(orderedBefore({0, 9, 9}, {1, 0, 0}));
    EXPECT_TRUE(orderedBefore({1, 0, 9}, {1, 1, 0}));
    EXPECT_TRUE(orderedBefore({1, 1, 0}, {1, 1, 1}));
    EXPECT_FALSE(orderedBefore({1, 1, 1}, {1, 1, 1}));
}

TEST(Weld, NegativeZeroIsZero) {
    const WeldedMesh mesh = welded(
        {{{0.0f, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0f, -0.0f, -0.0f}, {0, 0, 1}, {1, -0.0f, 0}},
         {0, 1, 2, 3, 4, 5}});
    EXPECT_EQ(mesh.positions.size(), 4u);
    for (const glm::vec3& p : mesh.positions)
        for (glm::length_t c = 0; c < 3; ++c)
            EXPECT_FALSE(std::signbit(p[c]));
}

TEST(Weld, OneUnitInTheLastPlaceApartIsApart) {
    const float near = std::nextafter(1.0f, 2.0f);
    const WeldedMesh mesh =
        welded({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {near, 0, 0}, {0, 0, 1}}, {0, 1, 2, 0, 3, 4}});
    EXPECT_EQ(mesh.positions.size(), 5u);
}

TEST(Weld, DenormalsAreNotZero) {
    const float tiny = std::nextafter(0.0f, 1.0f);
    const WeldedMesh mesh =
        welded({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {tiny, 0, 0}}, {0, 1, 2, 3, 1, 2}});
    EXPECT_EQ(mesh.positions.size(), 4u);
}

TEST(Weld, TrianglesOfTwoPositionsAreDroppedAndCounted) {
    // The second triangle repeats an index, the third a position, the fourth has only one position.
    const WeldedMesh mesh = welded(
        {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0f, 0, 0}}, {0, 1, 2, 1, 1, 2, 0, 2, 3, 0, 3, 0}});
    EXPECT_EQ(mesh.degenerate, 3u);
    EXPECT_EQ(mesh.triangles.size(), 1u);
}

TEST(Weld, CollinearTrianglesStay) {
    // 0---1---2: no area, but three edges that others may share.
    const WeldedMesh mesh = welded({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {0, 1, 2}});
    EXPECT_EQ(mesh.degenerate, 0u);
    EXPECT_EQ(mesh.triangles.size(), 1u);
}

TEST(Weld, SourceNamesTheGivenTriangle) {
    const WeldedMesh mesh =
        welded({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {1, 1, 2, 0, 1, 2, 0, 0, 0, 2, 1, 0}});
    EXPECT_EQ(mesh.source, (Indices{1, 3}));
}

TEST(Weld, OrientationIsKept) {
    const WeldedMesh mesh = welded({{{2, 0, 0}, {1, 0, 0}, {0, 0, 0}}, {0, 1, 2, 0, 2, 1}});
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{2, 1, 0}, {2, 0, 1}}));
}

TEST(Weld, PositionsWithoutATriangleAreDropped) {
    const WeldedMesh mesh =
        welded({{{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {-9, 0, 0}, {0, 1, 0}}, {1, 2, 4}});
    EXPECT_EQ(mesh.positions, (std::vector<glm::vec3>{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}));
}

} // namespace edgeshade::test
