#pragma once

#include "preprocess/mesh/edges.hpp"
#include "preprocess/mesh/weld.hpp"

#include <cstdint>
#include <vector>

namespace edgeshade {

/// Triangles connected through edges.
struct Components {
    std::vector<std::uint32_t> ofTriangle; ///< numbered in the order of their first triangles
    /// For each component, whether every edge has as many triangles in one direction as in the
    /// other. It is then closed as a chain, and winding numbers exist (docs/method.md, C8).
    std::vector<std::uint8_t> closed;

    std::size_t count() const { return closed.size(); }
};

/// Finds components across a batch's primitives, materials and meshes.
Components findComponents(const WeldedMesh& mesh, const EdgeList& edges, Threads threads = {});

/// A welded mesh, its edges and its components.
struct MeshTopology {
    WeldedMesh mesh;
    EdgeList edges;
    Components components;
};

/// All three of the triangles that `indices` lists.
MeshTopology topologyOf(const std::vector<glm::vec3>& positions,
                        const std::vector<std::uint32_t>& indices);

/// Whether the triangle runs through its edge from a to b (1) or from b to a (-1).
int directionIn(const Triangle& triangle, const Edge& edge);

} // namespace edgeshade
