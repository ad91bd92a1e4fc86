#pragma once

#include "preprocess/mesh/edges.hpp"

#include <glm/glm.hpp>
#include <optional>
#include <vector>

namespace edgeshade {

/// A triangle whose plane a record holds, negated where the triangle runs through the edge the
/// other way than its place in the record says.
struct PairedTriangle {
    std::uint32_t triangle = 0;
    bool negated = false;

    glm::vec4 planeIn(const std::vector<glm::vec4>& planes) const {
        return negated ? -planes[triangle] : planes[triangle];
    }
};

/// Two triangles of an edge, or one: the edge's multiplicity gets w(first) - w(second), see
/// plane_pair_data.hpp.
struct OppositePair {
    PairedTriangle first;
    std::optional<PairedTriangle> second;
};

/// The one record of an edge of one or two triangles, as nearly all are.
inline OppositePair onlyPair(const EdgeList& edges, const Edge& edge) {
    const Opposite* const opposites = &edges.opposites[edge.firstOpposite];
    const std::uint8_t* const forward = &edges.forward[edge.firstOpposite];
    const PairedTriangle p{opposites[0].triangle, forward[0] == 0};
    if (edge.oppositeCount == 1) return {p, std::nullopt};
    const PairedTriangle q{opposites[1].triangle, forward[1] != 0};
    if (forward[0] != forward[1])
        return forward[0] != 0 ? OppositePair{p, q}
                               : OppositePair{{q.triangle, false}, PairedTriangle{p.triangle}};
    // Both run one way: the second comes first.
    return {{q.triangle, p.negated}, PairedTriangle{p.triangle, !p.negated}};
}

/// Pairs up the triangles of an edge into ceil(n / 2) records: those that run opposite ways and
/// look the same way first, since these cancel in most lights. `planes`: of every triangle.
void pairUp(const EdgeList& edges, const Edge& edge, const std::vector<glm::vec4>& planes,
            std::vector<OppositePair>& pairs);

} // namespace edgeshade
