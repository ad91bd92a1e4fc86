#pragma once

#include "preprocess/mesh/components.hpp"

#include <cstddef>
#include <map>

namespace edgeshade {

/// Counts of a mesh's triangles and edges; += sums several meshes.
struct MeshStatistics {
    std::size_t triangles = 0; ///< without degenerate ones
    std::size_t degenerateTriangles = 0;
    std::size_t edges = 0;
    std::map<std::uint32_t, std::size_t> edgesByOppositeCount;
    std::size_t components = 0; ///< of triangles connected through edges
    /// Triangles of components that are closed as a chain: every edge has as many triangles in one
    /// direction as in the other, so that winding numbers exist (docs/method.md, C8).
    std::size_t closedOrientedTriangles = 0;

    std::uint32_t largestOppositeCount() const {
        return edgesByOppositeCount.empty() ? 0 : edgesByOppositeCount.rbegin()->first;
    }
    MeshStatistics& operator+=(const MeshStatistics& other);
};

/// Counts a mesh.
MeshStatistics meshStatistics(const WeldedMesh& mesh, const EdgeList& edges);
/// Counts a mesh whose components are known.
MeshStatistics meshStatistics(const WeldedMesh& mesh, const EdgeList& edges,
                              const Components& components);

} // namespace edgeshade
