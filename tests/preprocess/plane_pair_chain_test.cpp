// The closed chain (docs/method.md) of plane-pair records: for any signs, the emitted sides and
// caps of a cluster must have no boundary, with every triangle counted and, in closed clusters,
// with one facing alone.
#include "tests/support/plane_pair_chain.hpp"
#include "tests/support/small_soups.hpp"

#include <gtest/gtest.h>
#include <iostream>
#include <rapidcheck/gtest.h>

namespace edgeshade {
namespace {

using test::Soup;

/// An opaque soup with its records.
struct PlanePairMesh {
    CasterMesh mesh;
    EdgeList edges;
    PlanePairShadow shadow;

    explicit PlanePairMesh(const Soup& soup, double flatTolerance = 0.0) {
        mesh.welded = weld(soup.positions, soup.indices);
        const auto count = static_cast<std::uint32_t>(mesh.welded.triangles.size());
        if (count > 0) mesh.groups = {{0, 0, count}};
        edges = buildEdges(mesh.welded);
        shadow = buildPlanePairs(mesh, edges, {Material()}, flatTolerance);
    }

    std::size_t open(const glm::vec4& light) const {
        return test::openClusters(mesh.welded.positions, shadow, light);
    }
    std::size_t openEdges(const glm::vec4& light) const {
        return test::openEdges(mesh, edges, shadow, test::signsOf(shadow, light, test::countAll));
    }
};

constexpr double tolerances[] = {0.0, 0.1, 1.0, 10.0, 44.0}; // degrees

/// A sheet of 8 x 8 cells of one unit, its inner points lifted at random by up to `height`.
Soup bumpySheet(test::Random& random, double height) {
    constexpr std::uint32_t points = 9;
    Soup soup;
    for (std::uint32_t y = 0; y < points; ++y)
        for (std::uint32_t x = 0; x < points; ++x)
            soup.positions.emplace_back(x, y, height * random.inCube().z);
    for (std::uint32_t y = 0; y + 1 < points; ++y)
        for (std::uint32_t x = 0; x + 1 < points; ++x) {
            const std::uint32_t i = points * y + x;
            soup.indices.insert(soup.indices.end(),
                                {i, i + 1, i + points + 1, i, i + points + 1, i + points});
        }
    return soup;
}

const std::vector<glm::vec4> someLights = {{0.5f, 0.5f, 3, 1},   {3, 0.5f, 1, 1},     {0, 0, 1, 0},
                                           {2, 3, 0.5f, 1},      {1, 31.5f, 0.5f, 1}, {1, 1, 1, 1},
                                           {0.5f, 0.5f, 0.5f, 1}};

} // namespace

TEST(PlanePairChain, OfTinyMeshes) {
    for (const Soup& soup : {test::cube(), test::openBox(), test::fin(), test::fan(128),
                             test::moebiusStrip(), test::tJunction()})
        for (const double tolerance : tolerances)
            for (const glm::vec4& light : someLights)
                EXPECT_EQ(PlanePairMesh(soup, tolerance).open(light), 0u);
}

TEST(PlanePairChain, OfSheetsWhoseBumpsAreTakenForFlat) {
    test::Random random(23);
    std::size_t dropped = 0;
    for (int i = 0; i < 200; ++i) {
        const Soup sheet = bumpySheet(random, std::exp2(-random.below(12)));
        const glm::vec4 light(glm::dvec3(4.0) + 8.0 * random.inCube(), i % 2);
        std::size_t last = 0;
        for (const double tolerance : tolerances) {
            const PlanePairMesh mesh(sheet, tolerance);
            ASSERT_EQ(mesh.open(light), 0u) << i << ", " << tolerance;
            ASSERT_EQ(mesh.openEdges(light), 0u) << i << ", " << tolerance;
            EXPECT_GE(mesh.shadow.flatEdges, last) << i << ", " << tolerance;
            last = mesh.shadow.flatEdges;
        }
        dropped += last;
    }
    EXPECT_GT(dropped, 5000u);
}

TEST(PlanePairChain, WithoutARecordItIsOpen) {
    PlanePairMesh cube(test::cube());
    const glm::vec4 light(0.5f, 0.5f, 3, 1);
    ASSERT_EQ(cube.open(light), 0u);
    std::size_t opened = 0;
    for (std::size_t i = 0; i < cube.shadow.pairs.size(); ++i) {
        PlanePairMesh broken = cube;
        std::swap(broken.shadow.pairs[i].plane0, broken.shadow.pairs[i].plane1);
        opened += broken.open(light) > 0;
        EXPECT_EQ(broken.open(light) > 0, broken.openEdges(light) > 0);
    }
    EXPECT_GT(opened, 0u);
}

TEST(PlanePairChain, OfRandomSoupsForEveryKindOfLight) {
    test::Random random(5);
    std::size_t chains = 0, closed = 0;
    for (std::size_t i = 0; i < 20'000; ++i) {
        const Soup soup = test::randomSoup(random, 1 + random.below(24));
        const PlanePairMesh mesh(soup, tolerances[i % std::size(tolerances)]);
        if (mesh.shadow.caps.empty()) continue;
        const CapRecord& cap = mesh.shadow.caps.front();
        test::Corners corners = {cap.a, cap.b, cap.c};
        const glm::vec4 light = test::randomLight(
            random, corners, static_cast<test::LightKind>(i % test::lightKindCount));
        ASSERT_EQ(mesh.open(light), 0u) << i;
        ASSERT_EQ(mesh.openEdges(light), 0u) << i;
        ++chains;
        for (const ShadowCluster& cluster : mesh.shadow.clusters)
            closed += cluster.closed;
    }
    std::cout << "[ closed chain ] plane-pair records: 0 of " << chains << " open, " << closed
              << " clusters closed\n";
    EXPECT_GT(closed, 100u);
}

RC_GTEST_PROP(PlanePairChain, OfLatticeSoups, ()) {
    const Soup soup = test::latticeSoup();
    const glm::vec4 light = test::latticeLight();
    for (const double tolerance : tolerances) {
        const PlanePairMesh mesh(soup, tolerance);
        RC_ASSERT(mesh.open(light) == 0u);
        RC_ASSERT(mesh.openEdges(light) == 0u);
    }
}

RC_GTEST_PROP(PlanePairChain, MultiplicitiesAreThePublishedOnes, ()) {
    // On a small lattice both ways of finding a sign are exact, so that the silhouettes are the
    // same.
    const PlanePairMesh mesh(test::latticeSoup());
    const glm::vec4 light = test::latticeLight();
    const auto oppositeVertices = test::silhouetteOf<shader_arithmetic::ReferenceEdge>(
        buildSides(mesh.mesh.welded.positions, mesh.edges, 5), light);
    test::Silhouette planePairs;
    const auto add = [&](const auto& record) {
        planePairs[{test::pointOf(glm::vec4(record.a, 0)),
                    test::pointOf(glm::vec4(record.b, 0))}] +=
            test::multiplicityOf(record, light, test::countAll);
    };
    // Unit normals are rounded, so lights next to a plane are left out.
    for (const CapRecord& cap : mesh.shadow.caps) {
        const glm::dvec3 normal = glm::cross(glm::dvec3(cap.b - cap.a), glm::dvec3(cap.c - cap.a));
        const double side =
            glm::dot(normal, glm::dvec3(light) - glm::dvec3(cap.a) * static_cast<double>(light.w));
        if (side == 0.0) RC_SUCCEED("a light in a plane");
    }
    for (const PairRecord& pair : mesh.shadow.pairs)
        add(pair);
    for (const SingleRecord& single : mesh.shadow.singles)
        add(single);
    std::erase_if(planePairs, [](const auto& entry) { return entry.second == 0; });
    RC_ASSERT(planePairs == oppositeVertices);
}

} // namespace edgeshade
