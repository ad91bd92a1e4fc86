#pragma once

#include "preprocess/mesh/edges.hpp"

#include <glm/glm.hpp>
#include <optional>
#include <vector>

namespace edgeshade {

/// A triangle whose plane a record holds. The plane is negated if the triangle runs through the
/// edge in the other direction than its position in the record implies.
struct PairedTriangle {
    std::uint32_t triangle = 0;
    bool negated = false;

    glm::vec4 planeIn(const std::vector<glm::vec4>& planes) const {
        return negated ? -planes[triangle] : planes[triangle];
    }
};

/// One or two triangles of an edge: they add w(first) - w(second) to its multiplicity, see
/// plane_pair_data.hpp.
struct OppositePair {
    PairedTriangle first;
    std::optional<PairedTriangle> second;
};

/// The only record of an edge with one or two triangles; nearly all edges are such.
inline OppositePair onlyPair(const EdgeList& edges, const Edge& edge) {
    const Opposite* const opposites = &edges.opposites[edge.firstOpposite];
    const std::uint8_t* const forward = &edges.forward[edge.firstOpposite];
    const PairedTriangle p{opposites[0].triangle, forward[0] == 0};
    if (edge.oppositeCount == 1) return {p, std::nullopt};
    const PairedTriangle q{opposites[1].triangle, forward[1] != 0};
    if (forward[0] != forward[1])
        return forward[0] != 0 ? OppositePair{p, q}
                               : OppositePair{{q.triangle, false}, PairedTriangle{p.triangle}};
    // Both run the same way: the second comes first.
    return {{q.triangle, p.negated}, PairedTriangle{p.triangle, !p.negated}};
}

/// Pairs up the triangles of an edge into ceil(n / 2) records. Triangles that run in opposite
/// directions and face alike are paired first, as these cancel in most lights. `planes`: one per
/// triangle.
void pairUp(const EdgeList& edges, const Edge& edge, const std::vector<glm::vec4>& planes,
            std::vector<OppositePair>& pairs);

} // namespace edgeshade
