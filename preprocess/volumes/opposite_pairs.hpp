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

/// Pairs up the triangles of an edge into ceil(n / 2) records: those that run opposite ways and
/// look the same way first, since these cancel in most lights. `planes`: of every triangle.
void pairUp(const EdgeList& edges, const Edge& edge, const std::vector<glm::vec4>& planes,
            std::vector<OppositePair>& pairs);

} // namespace edgeshade
