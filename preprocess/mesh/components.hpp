#pragma once

#include "preprocess/mesh/edges.hpp"

#include <cstdint>
#include <vector>

namespace edgeshade {

/// Triangles connected through edges.
struct Components {
    std::vector<std::uint32_t> ofTriangle; ///< numbered by their first triangles
    /// Of each component: every edge has as many triangles in one direction as in the other, so
    /// that it is closed as a chain and winding numbers exist (docs/method.md, C8).
    std::vector<std::uint8_t> closed;

    std::size_t count() const { return closed.size(); }
};

/// Finds them, in whatever primitives, materials and meshes of a batch their triangles are.
Components findComponents(const WeldedMesh& mesh, const EdgeList& edges, Threads threads = {});

/// Whether the triangle runs through its edge from a to b (1) or from b to a (-1).
int directionIn(const Triangle& triangle, const Edge& edge);

} // namespace edgeshade
