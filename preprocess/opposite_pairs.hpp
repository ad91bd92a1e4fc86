#pragma once

#include "preprocess/edges.hpp"

#include <glm/glm.hpp>
#include <optional>
#include <vector>

namespace edgeshade {

/// Two triangles of an edge, or one: the edge's multiplicity gets w(first) - w(second), see
/// adapted_data.hpp. A plane is negated where the triangle runs the other way than its place says.
struct OppositePair {
    glm::vec4 first;
    std::optional<glm::vec4> second;
};

/// Pairs up the triangles of an edge into ceil(n / 2) records: those that run opposite ways and
/// look the same way first, since these cancel in most lights. `planes`: of every triangle.
void pairUp(const WeldedMesh& mesh, const EdgeList& edges, const Edge& edge,
            const std::vector<glm::vec4>& planes, std::vector<OppositePair>& pairs);

} // namespace edgeshade
