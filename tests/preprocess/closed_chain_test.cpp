// The closed chain (docs/method.md): for any signs, the emitted sides and caps must have no
// boundary. This test builds the chain itself, triangle by triangle, from the packer's records;
// closed_chain_bulk_test.cpp tries many more by their multiplicities alone.
#include "open_chain_tally.hpp"
#include "preprocess/volumes/shadow_data.hpp"
#include "tests/support/emitted_chain.hpp"
#include "tests/support/open_edges.hpp"
#include "tests/support/small_soups.hpp"

#include <gtest/gtest.h>
#include <iostream>
#include <rapidcheck/gtest.h>
#include <string>

namespace edgeshade::test {
namespace {

using namespace shader_arithmetic;

/// A mesh with its records, unexpanded and expanded.
struct PackedMesh {
    BatchTopology topology;
    BatchShadow shadow;
    std::vector<glm::vec4> expandedSides, expandedCaps;

    PackedMesh(const Soup& soup, int maxMultiplicity) {
        topology.mesh.welded = weld(soup.positions, soup.indices);
        topology.edges = buildEdges(topology.mesh.welded);
        shadow = buildShadow(topology, maxMultiplicity);
        expandedSides = expandSides(shadow.sides, 0, shadow.sides.recordCount());
        expandedCaps = expandCaps(shadow.caps, 0, shadow.caps.recordCount());
    }
};

template <class Method>
Chain chainOf(const PackedMesh& mesh, const glm::vec4& light) {
    return emittedChain<Method>(mesh.topology.mesh.welded.positions, mesh.expandedSides,
                                mesh.shadow.sides.vectorsPerRecord(), mesh.expandedCaps, light);
}

template <class Method>
bool isClosed(const Soup& soup, const glm::vec4& light) {
    return chainOf<Method>(PackedMesh(soup, 5), light).isCycle();
}

/// Open chains by method, and the number of times the two verdicts differ.
struct ChainCount {
    std::array<std::size_t, chainMethodCount> open{};
    std::size_t differing = 0;
    std::size_t chains = 0;

    template <class Method>
    bool add(ChainMethod method, const PackedMesh& mesh, const glm::vec4& light) {
        const bool isOpen = !chainOf<Method>(mesh, light).isCycle();
        open[static_cast<std::size_t>(method)] += isOpen;
        differing += isOpen != (openEdgesOf<Method>(mesh.topology, mesh.shadow, light) > 0);
        return isOpen;
    }

    std::array<bool, chainMethodCount> addAll(const PackedMesh& mesh, const glm::vec4& light) {
        ++chains;
        return {add<ReferenceEdge>(ChainMethod::referenceEdge, mesh, light),
                add<ThreeEdge>(ChainMethod::threeEdge, mesh, light),
                add<SingleEdge>(ChainMethod::singleEdge, mesh, light)};
    }

    void report(const std::string& what) const {
        constexpr const char* methods[] = {"reference edge", "three edge", "single edge"};
        for (std::size_t method = 0; method < chainMethodCount; ++method)
            std::cout << "[ closed chain ] " << methods[method] << ", " << what << ": "
                      << open[method] << " of " << chains << " open\n";
    }
};

/// A = (0,0,0), B = (0,1,0), C = (1,0,0); from above A, B, C is clockwise.
const Soup oneTriangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2}};

} // namespace

TEST(Chain, ATetrahedronIsACycleAndWithoutAFaceIsNot) {
    Chain chain(4);
    chain.addTriangle(0, 2, 1);
    chain.addTriangle(0, 1, 3);
    chain.addTriangle(1, 2, 3);
    EXPECT_FALSE(chain.isCycle());
    chain.addTriangle(2, 0, 3);
    EXPECT_TRUE(chain.isCycle());
}

TEST(Chain, ATurnedFaceBreaksACycle) {
    Chain chain(4);
    chain.addTriangle(0, 1, 2);
    chain.addTriangle(0, 1, 3);
    chain.addTriangle(1, 2, 3);
    chain.addTriangle(2, 0, 3);
    EXPECT_FALSE(chain.isCycle());
}

TEST(EmittedChain, OfATriangleIsAPrism) {
    // From either side two caps and three sides of two triangles each; nothing in its plane.
    const PackedMesh mesh(oneTriangle, 1);
    EXPECT_EQ(chainOf<ReferenceEdge>(mesh, {0, 0, 5, 1}).triangleCount(), 8u);
    EXPECT_EQ(chainOf<ReferenceEdge>(mesh, {0, 0, -5, 0}).triangleCount(), 8u);
    EXPECT_EQ(chainOf<ReferenceEdge>(mesh, {5, 5, 0, 1}).triangleCount(), 0u);
}

TEST(EmittedChain, SidesHaveThePublishedCorners) {
    // m > 0: (P2,P1,P0), (P1,P2,P3); m < 0 the reverse, with P0 = A, P1 = B, P2 and P3 their
    // points at infinity (thesis, Equations 6.3 to 6.5). Vertices: 2 i is finite, 2 i + 1 is not.
    const PackedMesh mesh(oneTriangle, 1);
    const auto corners = [&](const glm::vec4& light) {
        std::vector<ChainVertex> emitted;
        for (std::size_t v = 0; v < 6; ++v) {
            const auto record = std::span(mesh.expandedSides).subspan(3 * v, 3); // edge A-B
            emitted.push_back(
                sideVertex<ReferenceEdge>(mesh.topology.mesh.welded.positions, record, light)
                    .value());
        }
        return emitted;
    };
    EXPECT_EQ(corners({0, 0, -5, 1}), (std::vector<ChainVertex>{1, 2, 0, 2, 1, 3})); // m = 1
    EXPECT_EQ(corners({0, 0, 5, 1}), (std::vector<ChainVertex>{0, 2, 1, 3, 1, 2}));  // m = -1
}

TEST(EmittedChain, CapsFaceTheLight) {
    // From above A, C, B is counter-clockwise: the front cap is B A C (A and B swapped), the back
    // cap the reverse at infinity.
    const PackedMesh mesh(oneTriangle, 1);
    const auto corners = [&](const glm::vec4& light) {
        std::vector<ChainVertex> emitted;
        for (std::size_t v = 0; v < 6; ++v) {
            const auto record = std::span(mesh.expandedCaps).subspan(3 * v, 3);
            emitted.push_back(
                capVertex<ReferenceEdge>(mesh.topology.mesh.welded.positions, record, light)
                    .value());
        }
        return emitted;
    };
    EXPECT_EQ(corners({0, 0, 5, 1}), (std::vector<ChainVertex>{2, 0, 4, 5, 1, 3}));
    EXPECT_EQ(corners({0, 0, -5, 1}), (std::vector<ChainVertex>{0, 2, 4, 5, 3, 1}));
}

TEST(EmittedChain, SidesAreAsManyAsTheMultiplicity) {
    // The fan's spine at 128 of one sign: 128 sides, from 26 records; the other 256 edges one
    // side each; 128 pairs of caps.
    const PackedMesh mesh(fan(128), 5);
    const Chain chain = chainOf<ReferenceEdge>(mesh, {0, 1, 0, 0});
    EXPECT_EQ(chain.triangleCount(), 2u * (128 + 256) + 2u * 128);
    EXPECT_TRUE(chain.isCycle());
}

TEST(ClosedChain, OfTinyMeshes) {
    for (const Soup& soup : {cube(), openBox(), fin(), fan(128), moebiusStrip(), tJunction()})
        for (const glm::vec4 light :
             {glm::vec4(0.5, 0.5, 3, 1), glm::vec4(3, 0.5, 1, 1), glm::vec4(0, 0, 1, 0),
              glm::vec4(2, 3, 0.5, 1), glm::vec4(1, 31.5, 0.5, 1), glm::vec4(1, 1, 1, 1)}) {
            EXPECT_TRUE(isClosed<ReferenceEdge>(soup, light));
            EXPECT_TRUE(isClosed<ThreeEdge>(soup, light));
            EXPECT_TRUE(isClosed<SingleEdge>(soup, light)); // small integers: exact
        }
}

TEST(ClosedChain, OfATriangleForEveryKindOfLight) {
    Random random(1);
    ChainCount count;
    std::size_t differingFromTally = 0;
    for (std::size_t i = 0; i < 140'000; ++i) {
        const Corners corners = randomTriangle(random);
        const glm::vec4 light =
            randomLight(random, corners, static_cast<LightKind>(i % lightKindCount));
        const PackedMesh mesh({{corners.begin(), corners.end()}, {0, 1, 2}}, 1);
        differingFromTally += count.addAll(mesh, light) != isOpenByMethod(corners, light);
    }
    count.report("a triangle's whole chain");
    EXPECT_EQ(count.open[0], 0u);
    EXPECT_EQ(count.open[1], 0u);
    EXPECT_GT(count.open[2], 0u);
    EXPECT_EQ(count.differing, 0u);
    EXPECT_EQ(differingFromTally, 0u) << "the bulk test's shortcut is not the chain's verdict";
}

TEST(ClosedChain, TheTallyCountsWhatTheChainsSay) {
    // The same pairs, now as whole chains.
    constexpr std::uint64_t pairs = 35'000, seed = 3;
    const OpenChainTally tally = tallyOpenChains(pairs, seed);
    OpenChainTally expected;
    Random random(seed);
    for (std::size_t i = 0; i < pairs; ++i) {
        const std::size_t kind = i % lightKindCount;
        const Corners corners = randomTriangle(random);
        const glm::vec4 light = randomLight(random, corners, static_cast<LightKind>(kind));
        const PackedMesh mesh({{corners.begin(), corners.end()}, {0, 1, 2}}, 1);
        ChainCount count;
        const auto open = count.addAll(mesh, light);
        ++expected.pairs[kind];
        expected.casting[kind] += chainOf<ReferenceEdge>(mesh, light).triangleCount() > 0;
        for (std::size_t method = 0; method < chainMethodCount; ++method)
            expected.open[method][kind] += open[method];
    }
    EXPECT_EQ(tally.pairs, expected.pairs);
    EXPECT_EQ(tally.casting, expected.casting);
    EXPECT_EQ(tally.open, expected.open);
}

TEST(ClosedChain, OfSoupsWithSplitRecords) {
    Random random(2);
    ChainCount count;
    std::size_t splitEdges = 0, trianglesWithLights = 0;
    for (int i = 0; i < 2'000; ++i) {
        const Soup soup = randomSoup(random, 4 + random.below(40));
        const PackedMesh mesh(soup, 1 + random.below(LARGEST_RECORD_MULTIPLICITY));
        splitEdges += mesh.shadow.sides.recordCount() - mesh.topology.edges.edges.size();
        const auto& welded = mesh.topology.mesh.welded;
        if (welded.triangles.empty()) continue;
        for (std::size_t kind = 0; kind < lightKindCount; ++kind) {
            const auto aim =
                static_cast<std::size_t>(random.below(static_cast<int>(welded.triangles.size())));
            Corners corners;
            for (std::size_t c = 0; c < 3; ++c)
                corners[c] = welded.positions[welded.triangles[aim][c]];
            count.addAll(mesh, randomLight(random, corners, static_cast<LightKind>(kind)));
            trianglesWithLights += welded.triangles.size();
        }
    }
    count.report("soups of " + std::to_string(trianglesWithLights) + " triangle-light pairs");
    EXPECT_GT(splitEdges, 1000u);
    EXPECT_EQ(count.open[0], 0u);
    EXPECT_EQ(count.open[1], 0u);
    EXPECT_GT(count.open[2], 0u);
    EXPECT_EQ(count.differing, 0u);
}

RC_GTEST_PROP(ClosedChain, HoldsForAnySoupAndLight, ()) {
    const Soup soup = latticeSoup();
    const glm::vec4 light = latticeLight();
    const PackedMesh mesh(soup, *rc::gen::inRange(1, LARGEST_RECORD_MULTIPLICITY + 1));
    RC_ASSERT(chainOf<ReferenceEdge>(mesh, light).isCycle());
    RC_ASSERT(chainOf<ThreeEdge>(mesh, light).isCycle());
}

} // namespace edgeshade::test
