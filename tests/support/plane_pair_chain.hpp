#pragma once

// The shaders' output for plane-pair records, as a chain over symbolic vertices; emitted_chain.hpp
// does the same for published ones.

#include "preprocess/mesh/components.hpp"
#include "preprocess/volumes/plane_pair_data.hpp"
#include "tests/support/emitted_chain.hpp"

#include <array>
#include <cmath>

namespace edgeshade::test {

/// Values of the shaders' u_counted: every triangle counts, or only those that face the light, or
/// away.
inline const glm::vec2 countAll(-1.0f, 1.0f), countLightFacing(0.0f, 1.0f),
    countFacingAway(-1.0f, 0.0f);

/// plane_pair_sides.vert's recordMultiplicity().
inline int multiplicityOf(const PairRecord& pair, const glm::vec4& light,
                          const glm::vec2& counted) {
    shader_arithmetic::Plane shader;
    return static_cast<int>(std::lround(shader.countedSide(pair.plane0, light, 0.0f, counted) -
                                        shader.countedSide(pair.plane1, light, 0.0f, counted)));
}
inline int multiplicityOf(const SingleRecord& single, const glm::vec4& light,
                          const glm::vec2& counted) {
    return static_cast<int>(
        std::lround(shader_arithmetic::Plane{}.countedSide(single.plane, light, 0.0f, counted)));
}

/// plane_pair_caps.vert's `facing`.
inline int facingOf(const CapRecord& cap, const glm::vec4& light, const glm::vec2& counted) {
    return static_cast<int>(
        std::lround(shader_arithmetic::Plane{}.countedSide(cap.plane, light, 0.0f, counted)));
}

/// plane_pair_sides.vert's main() for quad `side` of a record of that multiplicity.
inline void emitQuad(Chain& chain, std::size_t a, std::size_t b, int multiplicity, int side) {
    if (!(side < std::abs(multiplicity))) return;
    const auto vertex = [&](int corner) {
        if (multiplicity < 0 && (corner == 0 || corner == 3)) corner = 3 - corner;
        const std::size_t end = corner == 0 || corner == 2 ? a : b;
        return ChainVertex{2 * end + (corner > 1 ? 1u : 0u)};
    };
    chain.addTriangle(vertex(2), vertex(1), vertex(0));
    chain.addTriangle(vertex(1), vertex(2), vertex(3));
}

/// All sides and caps of a cluster.
inline Chain planePairChain(std::span<const glm::vec3> sortedPositions,
                            const PlanePairShadow& shadow, const ShadowCluster& cluster,
                            const glm::vec4& light, const glm::vec2& counted) {
    Chain chain(sortedPositions.size());
    const auto vertexOf = [&](const glm::vec3& p) {
        return indexOf(sortedPositions, glm::vec4(p, 0.0f));
    };
    const auto emitRecord = [&](const auto& record) {
        for (const int side : {0, 1})
            emitQuad(chain, vertexOf(record.a), vertexOf(record.b),
                     multiplicityOf(record, light, counted), side);
    };
    for (std::uint32_t i = cluster.pairs.first; i < cluster.pairs.end(); ++i)
        emitRecord(shadow.pairs[i]);
    for (std::uint32_t i = cluster.singles.first; i < cluster.singles.end(); ++i)
        emitRecord(shadow.singles[i]);
    for (std::uint32_t i = cluster.caps.first; i < cluster.caps.end(); ++i) {
        const CapRecord& cap = shadow.caps[i];
        const int facing = facingOf(cap, light, counted);
        if (facing == 0) continue;
        ChainVertex a = 2 * vertexOf(cap.a), b = 2 * vertexOf(cap.b);
        const ChainVertex c = 2 * vertexOf(cap.c);
        if (facing < 0) std::swap(a, b);
        chain.addTriangle(a, b, c);
        chain.addTriangle(c + 1, b + 1, a + 1);
    }
    return chain;
}

/// Number of clusters whose chains are not closed, for every way of counting them. Memory grows
/// with the square of the positions.
inline std::size_t openClusters(std::span<const glm::vec3> sortedPositions,
                                const PlanePairShadow& shadow, const glm::vec4& light) {
    std::size_t open = 0;
    for (const ShadowCluster& cluster : shadow.clusters) {
        std::vector<glm::vec2> ways = {countAll};
        if (cluster.closed) ways.insert(ways.end(), {countLightFacing, countFacingAway});
        for (const glm::vec2& counted : ways)
            open += !planePairChain(sortedPositions, shadow, cluster, light, counted).isCycle();
    }
    return open;
}

/// A shader's results for all records of a batch: multiplicities of pairs and of singles, facings
/// of caps.
struct PlanePairSigns {
    std::vector<int> pairs, singles, caps;
};

inline PlanePairSigns signsOf(const PlanePairShadow& shadow, const glm::vec4& light,
                              const glm::vec2& counted) {
    PlanePairSigns signs;
    for (const PairRecord& pair : shadow.pairs)
        signs.pairs.push_back(multiplicityOf(pair, light, counted));
    for (const SingleRecord& single : shadow.singles)
        signs.singles.push_back(multiplicityOf(single, light, counted));
    for (const CapRecord& cap : shadow.caps)
        signs.caps.push_back(facingOf(cap, light, counted));
    return signs;
}

/// Number of edges at which sides don't fit caps, in time linear in the mesh.
inline std::size_t openEdges(const CasterMesh& mesh, const EdgeList& edges,
                             const PlanePairShadow& shadow, const PlanePairSigns& signs) {
    std::map<std::pair<Point, Point>, int> sums;
    const auto sumAt = [&](const glm::vec3& a, const glm::vec3& b) -> int& {
        return sums[{Point{a.x, a.y, a.z}, Point{b.x, b.y, b.z}}];
    };
    for (std::size_t i = 0; i < shadow.pairs.size(); ++i)
        sumAt(shadow.pairs[i].a, shadow.pairs[i].b) += signs.pairs[i];
    for (std::size_t i = 0; i < shadow.singles.size(); ++i)
        sumAt(shadow.singles[i].a, shadow.singles[i].b) += signs.singles[i];
    std::vector<int> facing(mesh.welded.triangles.size());
    for (std::size_t i = 0; i < shadow.caps.size(); ++i)
        facing[shadow.capTriangles[i]] = signs.caps[i];
    std::size_t open = 0;
    for (const Edge& edge : edges.edges) {
        int fromCaps = 0;
        for (const Opposite& opposite : edges.oppositesOf(edge))
            fromCaps += directionIn(mesh.welded.triangles[opposite.triangle], edge) *
                        facing[opposite.triangle];
        open += sumAt(mesh.welded.positions[edge.a], mesh.welded.positions[edge.b]) != fromCaps;
    }
    return open;
}

} // namespace edgeshade::test
