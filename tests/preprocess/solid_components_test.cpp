// Components that are surfaces of solids, in addition to those in CullingPlan's scenes
// (docs/method.md, C39).
#include "preprocess/mesh/solid_components.hpp"
#include "preprocess/mesh/triangle_crossing.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace edgeshade {
namespace {

/// Triangles given by their corners.
struct Soup {
    std::vector<glm::vec3> corners;

    void add(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
        corners.insert(corners.end(), {a, b, c});
    }
    void addTetrahedron(const glm::vec3& at, float size, bool inwards = false) {
        const glm::vec3 a = at, b = at + glm::vec3(size, 0, 0), c = at + glm::vec3(0, size, 0),
                        d = at + glm::vec3(0, 0, size);
        for (const auto& [p, q, r] :
             {std::array{a, c, b}, std::array{a, b, d}, std::array{a, d, c}, std::array{b, c, d}})
            inwards ? add(p, r, q) : add(p, q, r);
    }
    /// A cone with this many sides, over a disc.
    void addCone(int sides, float radius, float rise) {
        const auto rim = [&](int i) {
            const float angle = 2.0f * std::numbers::pi_v<float> * static_cast<float>(i % sides) /
                                static_cast<float>(sides);
            return glm::vec3(radius * std::cos(angle), 0.0f, radius * std::sin(angle));
        };
        for (int i = 0; i < sides; ++i) {
            add({0, rise, 0}, rim(i + 1), rim(i));
            add({0, 0, 0}, rim(i), rim(i + 1));
        }
    }

    std::vector<std::uint8_t> solids() const {
        std::vector<std::uint32_t> indices(corners.size());
        for (std::uint32_t i = 0; i < indices.size(); ++i)
            indices[i] = i;
        const WeldedMesh mesh = weld(corners, indices);
        const EdgeList edges = buildEdges(mesh);
        return solidComponents(mesh, edges, findComponents(mesh, edges));
    }
};

using Flags = std::vector<std::uint8_t>;

TEST(SolidComponents, AreToldOneByOne) {
    Soup soup;
    soup.addTetrahedron({0, 0, 0}, 1);
    soup.addTetrahedron({5, 0, 0}, 1, true);
    soup.addTetrahedron({0.2f, 0.2f, 0.2f}, 1); // crosses the first, not itself
    soup.add({9, 0, 0}, {9, 1, 0}, {9, 0, 1});
    EXPECT_EQ(soup.solids(), (Flags{1, 0, 1, 0}));
    EXPECT_EQ(Soup().solids(), Flags{});
}

TEST(SolidComponents, ThatTouchThemselvesAreAndThatCrossThemselvesAreNot) {
    // A fold: a spike through the opposite side, and one that only touches it.
    for (const float tip : {0.9f, 1.5f}) {
        Soup soup;
        const glm::vec3 a(0, 0, 0), b(4, 0, 0), c(4, 0, 4), d(0, 0, 4), apex(2, 1, 2);
        const glm::vec3 in(2, tip, 2); // a point of the floor, pulled upwards
        for (const auto& [p, q] : {std::pair{a, b}, {b, c}, {c, d}, {d, a}}) {
            soup.add(apex, q, p);
            soup.add(in, p, q);
        }
        EXPECT_EQ(soup.solids(), Flags{tip < 1.0f}) << tip;
    }
}

TEST(SolidComponents, OfAnySizeAndPlace) {
    for (const float size : {1e-30f, 1e-6f, 1.0f, 1e12f}) {
        Soup soup;
        soup.addTetrahedron({0, 0, 0}, size);
        soup.addTetrahedron({3 * size, 0, 0}, size, true);
        EXPECT_EQ(soup.solids(), (Flags{1, 0})) << size;
    }
    Soup far;
    far.addTetrahedron({1e6f, -1e6f, 1e6f}, 1);
    EXPECT_EQ(far.solids(), Flags{1});
}

TEST(SolidComponents, EdgesOfFourTrianglesAreNoManifold) {
    Soup soup;
    soup.addTetrahedron({0, 0, 0}, 1);
    // Another component over the same edge, on its other side.
    soup.add({0, 0, 0}, {1, 0, 0}, {0, -1, 0});
    soup.add({0, 0, 0}, {0, -1, 0}, {0, 0, -1});
    soup.add({0, 0, 0}, {0, 0, -1}, {1, 0, 0});
    soup.add({1, 0, 0}, {0, 0, -1}, {0, -1, 0});
    EXPECT_EQ(soup.solids(), Flags{0});
}

// The boxes of all triangles around a vertex overlap there: testing each pair would take minutes.
TEST(SolidComponents, WithAVertexOfManyTrianglesAreGivenUp) {
    Soup few, many;
    few.addCone(50, 1, 1);
    many.addCone(60'000, 1, 1);
    EXPECT_EQ(few.solids(), Flags{1});
    EXPECT_EQ(many.solids(), Flags{0});
}

TEST(TriangleCrossing, IsMoreThanAContact) {
    const TriangleCorners floor = {{{0, 0, 0}, {4, 0, 0}, {0, 0, 4}}};
    const auto with = [&](const TriangleCorners& other) { return mayCross({floor, other}); };
    EXPECT_FALSE(with({{{1, 0, 1}, {1, 2, 1}, {2, 2, 1}}})) << "a corner on it";
    EXPECT_TRUE(with({{{1, -0.1, 1}, {1, 2, 1}, {2, 2, 1}}})) << "a corner through it";
    EXPECT_FALSE(with({{{0, 0, 0}, {4, 0, 0}, {0, 3, 4}}})) << "a common edge";
    EXPECT_FALSE(with({{{4, 0, 0}, {4, 0, 4}, {0, 0, 4}}})) << "beside it in its plane";
    EXPECT_TRUE(with({{{1, 0, 1}, {4, 0, 4}, {0, 0, 4}}})) << "over it in its plane";
    EXPECT_FALSE(with({{{9, 0, 9}, {9, 1, 9}, {8, 0, 9}}})) << "apart";
    EXPECT_FALSE(mayCross({}));
}

} // namespace
} // namespace edgeshade
