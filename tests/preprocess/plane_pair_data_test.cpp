#include "preprocess/volumes/clustering.hpp"
#include "preprocess/volumes/plane_pair_data.hpp"

#include "preprocess/mesh/coplanar.hpp"
#include "preprocess/volumes/opposite_pairs.hpp"
#include "preprocess/volumes/triangle_planes.hpp"
#include "tests/support/hard_lights.hpp"
#include "tests/support/tiny_meshes.hpp"

#include <gtest/gtest.h>
#include <set>

namespace edgeshade {
namespace {

using test::Soup;

CasterMesh casterMesh(const Soup& soup) {
    CasterMesh mesh;
    mesh.welded = weld(soup.positions, soup.indices);
    mesh.groups = {{0, 0, static_cast<std::uint32_t>(mesh.welded.triangles.size())}};
    return mesh;
}

PlanePairShadow planePairsOf(const Soup& soup) {
    const CasterMesh mesh = casterMesh(soup);
    return buildPlanePairs(mesh, buildEdges(mesh.welded), {Material()});
}

/// A square of 2 x 2 cells, two triangles each, lifted by `height` at its centre.
Soup sheet(float height) {
    Soup soup;
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 3; ++x)
            soup.positions.emplace_back(x, y, x == 1 && y == 1 ? height : 0.0f);
    for (std::uint32_t y = 0; y < 2; ++y)
        for (std::uint32_t x = 0; x < 2; ++x) {
            const std::uint32_t i = 3 * y + x;
            soup.indices.insert(soup.indices.end(), {i, i + 1, i + 4, i, i + 4, i + 3});
        }
    return soup;
}

void append(Soup& soup, const Soup& more, const glm::vec3& offset) {
    const auto first = static_cast<std::uint32_t>(soup.positions.size());
    for (const glm::vec3& p : more.positions)
        soup.positions.push_back(p + offset);
    for (const std::uint32_t i : more.indices)
        soup.indices.push_back(first + i);
}

} // namespace

TEST(Coplanar, IsExact) {
    EXPECT_TRUE(areCoplanar({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 7, 0}));
    EXPECT_FALSE(areCoplanar({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 7, 1e-30f}));
    EXPECT_TRUE(areCoplanar({1, 1, 1}, {1, 1, 1}, {0, 1, 0}, {5, 7, 0})); // two points coincide
    // On x + y = z, as exactly as floats can be.
    EXPECT_TRUE(areCoplanar({0.5f, 0.25f, 0.75f}, {3, 4, 7}, {-2, 0.125f, -1.875f}, {8, 8, 16}));
    EXPECT_FALSE(areCoplanar({0.5f, 0.25f, 0.75f}, {3, 4, 7}, {-2, 0.125f, -1.875f},
                             {8, 8, std::nextafter(16.0f, 17.0f)}));
}

TEST(Coplanar, AgreesWithIntegersOfAnySize) {
    // Points u a + v b with small integers, far away and scaled, then one of them moved by one
    // step.
    test::Random random(11);
    for (int i = 0; i < 20'000; ++i) {
        const auto number = [&] { return static_cast<double>(random.below(33) - 16); };
        const auto vector = [&] {
            const double x = number(), y = number(), z = number();
            return glm::dvec3(x, y, z);
        };
        const glm::dvec3 a = vector(), b = vector(), origin = 64.0 * vector();
        const double scale = std::exp2(random.below(40) - 20);
        std::array<glm::vec3, 4> p;
        for (glm::vec3& point : p) {
            const double u = number(), v = number();
            point = glm::vec3(scale * (origin + u * a + v * b));
        }
        EXPECT_TRUE(areCoplanar(p[0], p[1], p[2], p[3]));
        const glm::dvec3 normal = glm::cross(glm::dvec3(p[1] - p[0]), glm::dvec3(p[2] - p[0]));
        const auto axis = static_cast<glm::length_t>(random.below(3));
        if (normal[axis] == 0.0) continue;
        p[3][axis] = std::nextafter(p[3][axis], 1e30f);
        EXPECT_FALSE(areCoplanar(p[0], p[1], p[2], p[3]));
    }
}

TEST(TrianglePlanes, FlatPatchesShareOne) {
    const CasterMesh mesh = casterMesh(sheet(0.0f));
    const auto planes = trianglePlanes(mesh.welded, buildEdges(mesh.welded));
    for (const glm::vec4& plane : planes)
        EXPECT_EQ(plane, planes.front());
    EXPECT_EQ(planes.front(), glm::vec4(0, 0, 1, 0));
}

TEST(TrianglePlanes, LiftedALittleTheyDoNot) {
    const PlanePairShadow shadow = planePairsOf(sheet(1e-6f));
    EXPECT_EQ(shadow.flatPairs, 0u);
    EXPECT_EQ(shadow.pairs.size() + shadow.singles.size(), shadow.edges);
}

TEST(PlanePairData, EdgesWithinAFlatPatchAreDropped) {
    const PlanePairShadow shadow = planePairsOf(sheet(0.0f));
    EXPECT_EQ(shadow.edges, 16u);
    EXPECT_EQ(shadow.flatPairs, 8u);
    EXPECT_EQ(shadow.pairs.size(), 0u);
    EXPECT_EQ(shadow.singles.size(), 8u);
    EXPECT_EQ(shadow.caps.size(), 8u);
    ASSERT_EQ(shadow.clusters.size(), 1u);
    EXPECT_FALSE(shadow.clusters[0].closed);
}

TEST(PlanePairData, AFoldKeepsItsEdge) {
    // Two triangles in one plane, on the same side of their edge, which is a silhouette from
    // everywhere.
    const PlanePairShadow shadow =
        planePairsOf({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {0, 1, 2, 1, 0, 3}});
    EXPECT_EQ(shadow.flatPairs, 0u);
    EXPECT_EQ(shadow.pairs.size(), 1u);
}

TEST(PlanePairData, ACubeIsClosedAndItsDiagonalsGo) {
    const PlanePairShadow shadow = planePairsOf(test::cube());
    EXPECT_EQ(shadow.edges, 18u);
    EXPECT_EQ(shadow.flatPairs, 6u);
    EXPECT_EQ(shadow.pairs.size(), 12u);
    EXPECT_EQ(shadow.singles.size(), 0u);
    ASSERT_EQ(shadow.clusters.size(), 1u);
    EXPECT_TRUE(shadow.clusters[0].closed);
    EXPECT_EQ(shadow.clusters[0].caps.count, 12u);
}

TEST(PlanePairData, ATurnedTriangleOpensTheCube) {
    Soup soup = test::cube();
    std::swap(soup.indices[0], soup.indices[1]);
    const PlanePairShadow shadow = planePairsOf(soup);
    ASSERT_EQ(shadow.clusters.size(), 1u);
    EXPECT_FALSE(shadow.clusters[0].closed);
}

TEST(PlanePairData, AComponentWithHolesIsNotClosed) {
    CasterMesh mesh = casterMesh(test::cube());
    mesh.groups = {{0, 0, 10}, {1, 10, 2}};
    Material mask;
    mask.alphaMode = AlphaMode::mask;
    const PlanePairShadow shadow =
        buildPlanePairs(mesh, buildEdges(mesh.welded), {Material(), mask});
    ASSERT_EQ(shadow.clusters.size(), 1u);
    EXPECT_FALSE(shadow.clusters[0].closed);
    EXPECT_TRUE(shadow.clusters[0].alphaTested);
    ASSERT_EQ(shadow.groups.size(), 2u);
    EXPECT_EQ(shadow.groups[1].material, 1u);
    EXPECT_EQ(shadow.groups[1].firstCap, 10u);
    EXPECT_EQ(shadow.groups[1].capCount, 2u);
}

TEST(PlanePairData, MaterialsDoNotDivideAComponent) {
    CasterMesh mesh = casterMesh(test::cube());
    mesh.groups = {{0, 0, 7}, {1, 7, 5}};
    const PlanePairShadow shadow =
        buildPlanePairs(mesh, buildEdges(mesh.welded), {Material(), Material()});
    ASSERT_EQ(shadow.clusters.size(), 1u);
    EXPECT_TRUE(shadow.clusters[0].closed);
    EXPECT_EQ(shadow.groups.size(), 1u);
}

TEST(PlanePairData, ClustersHoldWholeComponentsAndEveryRecordOnce) {
    Soup soup;
    for (int x = 0; x < 10; ++x)
        for (int y = 0; y < 10; ++y)
            append(soup, (x + y) % 3 ? test::cube() : test::openBox(),
                   {3.0f * static_cast<float>(x), 3.0f * static_cast<float>(y), 0.0f});
    const PlanePairShadow shadow = planePairsOf(soup);
    EXPECT_GT(shadow.clusters.size(), 2u);
    std::uint32_t pairs = 0, singles = 0, caps = 0;
    bool open = false;
    for (const ShadowCluster& cluster : shadow.clusters) {
        EXPECT_EQ(cluster.pairs.first, pairs);
        EXPECT_EQ(cluster.singles.first, singles);
        EXPECT_EQ(cluster.caps.first, caps);
        EXPECT_LE(cluster.caps.count, clusterTriangles);
        pairs = cluster.pairs.end();
        singles = cluster.singles.end();
        caps = cluster.caps.end();
        EXPECT_FALSE(open && cluster.closed) << "closed ones come first";
        open = open || !cluster.closed;
        EXPECT_TRUE(!cluster.closed || cluster.singles.count == 0);
        for (std::uint32_t i = cluster.caps.first; i < caps; ++i)
            for (const glm::vec3& p : {shadow.caps[i].a, shadow.caps[i].b, shadow.caps[i].c})
                for (glm::length_t axis = 0; axis < 3; ++axis) {
                    EXPECT_GE(p[axis], cluster.bounds.low[axis]);
                    EXPECT_LE(p[axis], cluster.bounds.high[axis]);
                }
    }
    for (const ShadowCluster& cluster : shadow.clusters) {
        EXPECT_EQ(cluster.leaves.count, (cluster.caps.count + 31) / 32);
        for (std::uint32_t i = cluster.caps.first; i < cluster.caps.end(); ++i) {
            const glm::dvec3 a(shadow.caps[i].a), b(shadow.caps[i].b), c(shadow.caps[i].c);
            bool held = false;
            for (std::uint32_t p = cluster.leaves.first; p < cluster.leaves.end(); ++p) {
                const Box& part = shadow.leaves[p];
                const glm::dvec3 low = glm::min(a, glm::min(b, c));
                const glm::dvec3 high = glm::max(a, glm::max(b, c));
                held = held || (glm::all(glm::greaterThanEqual(low, part.low)) &&
                                glm::all(glm::lessThanEqual(high, part.high)));
            }
            EXPECT_TRUE(held) << "no part holds triangle " << i;
        }
    }
    EXPECT_EQ(pairs, shadow.pairs.size());
    EXPECT_EQ(singles, shadow.singles.size());
    EXPECT_EQ(caps, shadow.caps.size());
    EXPECT_EQ(
        std::set<std::uint32_t>(shadow.capTriangles.begin(), shadow.capTriangles.end()).size(),
        caps);
}

TEST(OppositePairs, ManyTrianglesTakeHalfAsManyRecords) {
    for (const int n : {1, 2, 3, 4, 7, 64, 128}) {
        const CasterMesh mesh = casterMesh(test::fan(n));
        const EdgeList edges = buildEdges(mesh.welded);
        const auto planes = trianglePlanes(mesh.welded, edges);
        const auto spine = std::max_element(
            edges.edges.begin(), edges.edges.end(),
            [](const Edge& a, const Edge& b) { return a.oppositeCount < b.oppositeCount; });
        std::vector<OppositePair> pairs;
        pairUp(edges, *spine, planes, pairs);
        EXPECT_EQ(pairs.size(), (spine->oppositeCount + 1) / 2);
    }
}

TEST(OppositePairs, AFanOfAnySizeTakesLittleTime) {
    // 200,000 triangles on one edge: comparing each with each would take hours.
    constexpr std::uint32_t n = 200'000;
    Soup soup{{{0, 0, 0}, {0, 1, 0}}, {}};
    for (std::uint32_t i = 0; i < n; ++i) {
        const float angle = static_cast<float>(i) * 3e-5f;
        soup.positions.emplace_back(std::cos(angle), 0.5f, std::sin(angle));
        soup.indices.insert(soup.indices.end(), {i % 2, 1 - i % 2, i + 2});
    }
    const PlanePairShadow shadow = planePairsOf(soup);
    EXPECT_GE(shadow.pairs.size(), n / 2 - 64);
    EXPECT_EQ(shadow.singles.size(), 2 * n);
}

TEST(OppositePairs, FlatOnesCancelFirst) {
    // A cross of two flat strips through one edge: both pairs go.
    const Soup cross{{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}},
                     {0, 1, 2, 1, 0, 3, 0, 1, 4, 1, 0, 5}};
    const PlanePairShadow shadow = planePairsOf(cross);
    EXPECT_EQ(shadow.flatPairs, 2u);
    EXPECT_EQ(shadow.pairs.size(), 0u);
}

namespace {

/// A sheet of triangles along x that bends by `degrees` at every line between cells.
Soup bentSheet(int cells, double degrees) {
    Soup soup;
    glm::dvec3 at(0.0);
    for (int i = 0; i <= cells; ++i) {
        soup.positions.push_back(at);
        soup.positions.push_back(at + glm::dvec3(0, 1, 0));
        const double slope = glm::radians(i * degrees);
        at += glm::dvec3(std::cos(slope), 0.0, std::sin(slope));
    }
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(2 * cells); i += 2)
        soup.indices.insert(soup.indices.end(), {i, i + 2, i + 3, i, i + 3, i + 1});
    return soup;
}

std::vector<glm::vec4> planesOf(const Soup& soup, double flatTolerance) {
    const WeldedMesh mesh = weld(soup.positions, soup.indices);
    return trianglePlanes(mesh, buildEdges(mesh), flatTolerance);
}

std::size_t differentPlanes(const std::vector<glm::vec4>& planes) {
    std::set<std::array<float, 4>> different;
    for (const glm::vec4& plane : planes)
        different.insert({plane.x, plane.y, plane.z, plane.w});
    return different.size();
}

} // namespace

TEST(FlatTolerance, NormalsDoNotDriftFromWherePatchesBegin) {
    const Soup sheet = bentSheet(20, 2.0);
    const auto exact = planesOf(sheet, 0.0);
    EXPECT_EQ(differentPlanes(exact), 20u);
    EXPECT_EQ(differentPlanes(planesOf(sheet, 1.9)), 20u);
    for (const double tolerance : {2.1, 5.0, 10.0}) {
        const auto planes = planesOf(sheet, tolerance);
        const auto reach = static_cast<std::size_t>(tolerance / 2.0);
        EXPECT_GE(differentPlanes(planes), 20 / (2 * reach + 1));
        EXPECT_LE(differentPlanes(planes), 20 / (reach + 1) + 1);
        for (std::size_t t = 0; t < planes.size(); ++t)
            EXPECT_GT(glm::dot(glm::dvec3(planes[t]), glm::dvec3(exact[t])),
                      std::cos(glm::radians(tolerance + 1e-3)));
    }
}

TEST(FlatTolerance, APatchTakesThePlaneOfItsLargestExactlyFlatPart) {
    Soup sheet = bentSheet(3, 1.0);
    for (std::size_t i = 6; i < 8; ++i) // the last cell, twice as long
        sheet.positions[i] += sheet.positions[i] - sheet.positions[i - 2];
    const auto exact = planesOf(sheet, 0.0);
    for (const glm::vec4& plane : planesOf(sheet, 3.0))
        EXPECT_EQ(plane, exact.back());
}

TEST(FlatTolerance, EdgesOfOtherThanTwoOppositeTrianglesAreNotCrossed) {
    // The fin's second page doesn't bend away from the first.
    const Soup fin = test::fin();
    EXPECT_EQ(differentPlanes(planesOf(fin, 44.0)), differentPlanes(planesOf(fin, 0.0)));
    // Two triangles of a flat sheet that run the same way along their edge.
    const Soup turned{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0.01f}}, {0, 1, 2, 1, 2, 3}};
    EXPECT_EQ(differentPlanes(planesOf(turned, 44.0)), 2u);
    const Soup right{turned.positions, {0, 1, 2, 2, 1, 3}};
    EXPECT_EQ(differentPlanes(planesOf(right, 44.0)), 1u);
    EXPECT_EQ(differentPlanes(planesOf(right, 0.0)), 2u);
}

TEST(FlatTolerance, RightAnglesStay) {
    const CasterMesh mesh = casterMesh(test::cube());
    const EdgeList edges = buildEdges(mesh.welded);
    EXPECT_EQ(buildPlanePairs(mesh, edges, {Material()}, 44.9).flatEdges,
              buildPlanePairs(mesh, edges, {Material()}).flatEdges);
}

} // namespace edgeshade
