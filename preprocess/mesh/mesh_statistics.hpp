#pragma once

#include "preprocess/mesh/components.hpp"

#include <cstddef>
#include <map>

namespace edgeshade {

/// What a mesh's edges say about it; sums over several meshes with +=.
struct MeshStatistics {
    std::size_t triangles = 0; ///< without the degenerate ones
    std::size_t degenerateTriangles = 0;
    std::size_t edges = 0;
    std::map<std::uint32_t, std::size_t> edgesByOppositeCount;
    std::size_t components = 0; ///< of triangles connected through edges
    /// Triangles of components whose edges all have as many triangles in one direction as in the
    /// other: closed as a chain, so that winding numbers exist (docs/method.md, C8).
    std::size_t closedOrientedTriangles = 0;

    std::uint32_t largestOppositeCount() const {
        return edgesByOppositeCount.empty() ? 0 : edgesByOppositeCount.rbegin()->first;
    }
    MeshStatistics& operator+=(const MeshStatistics& other);
};

/// Counts them.
MeshStatistics meshStatistics(const WeldedMesh& mesh, const EdgeList& edges);
/// The same where its components are known.
MeshStatistics meshStatistics(const WeldedMesh& mesh, const EdgeList& edges,
                              const Components& components);

} // namespace edgeshade
