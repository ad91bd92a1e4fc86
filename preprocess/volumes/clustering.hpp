#pragma once

#include "preprocess/mesh/topology.hpp"
#include "preprocess/scene/scene.hpp"

namespace edgeshade {

/// Caps that a part of a cluster holds.
inline constexpr std::uint32_t leafTriangles = 32;

/// Triangles at which a cluster is full: small components share one.
inline constexpr std::size_t clusterTriangles = 512;

/// Whole components that lie near each other and are alike: all closed and without holes, or none.
struct TriangleCluster {
    Box bounds;
    bool closed = false;
    bool holes = false; ///< some triangle is not opaque; never closed then
    std::uint32_t components = 0;
    std::vector<std::uint32_t> triangles; ///< with holes ascending, else along a Morton curve
    std::vector<std::uint32_t> edges;     ///< each where its first opposite vertex's triangle is
    std::vector<Box> leaves; ///< around leafTriangles consecutive triangles each, the last fewer
};

/// Divides a batch's casters: closed clusters first, then open ones, then those with holes; within
/// these along a Morton curve.
std::vector<TriangleCluster> clusterTrianglesOf(const CasterMesh& mesh, const EdgeList& edges,
                                                const std::vector<Material>& materials);

} // namespace edgeshade
