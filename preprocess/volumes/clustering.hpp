#pragma once

#include "preprocess/mesh/components.hpp"
#include "preprocess/mesh/topology.hpp"
#include "preprocess/scene/scene.hpp"

namespace edgeshade {

/// Caps in a leaf of a cluster.
inline constexpr std::uint32_t leafTriangles = 32;

/// Triangles at which a cluster is full; small components share one.
inline constexpr std::size_t clusterTriangles = 512;

/// Whole components near each other and of one kind: all closed and opaque, or none.
struct TriangleCluster {
    Box bounds;
    bool closed = false;
    bool alphaTested = false; ///< some triangle isn't opaque; then never closed
    std::uint32_t components = 0;
    std::uint32_t singleSided = 0; ///< its single-sided triangles, which come first
    ItemRange triangles, edges;    ///< ranges in TriangleClusters
};

struct TriangleClusters {
    std::vector<TriangleCluster> clusters;
    /// Cluster by cluster, single-sided triangles first in each; within these, ascending if
    /// alpha-tested, otherwise along a Morton curve.
    std::vector<std::uint32_t> triangles;
    std::vector<std::uint32_t> edges; ///< with the triangle of each edge's first opposite vertex
};

/// For each component, whether it counts as closed (docs/method.md, C8): it is closed and entirely
/// opaque.
std::vector<std::uint8_t> countsHalf(const CasterMesh& mesh, const Components& components,
                                     const std::vector<Material>& materials);

/// Divides a batch's casters into clusters: closed ones first, then open ones, then alpha-tested
/// ones; along a Morton curve within each kind.
TriangleClusters clusterTrianglesOf(const CasterMesh& mesh, const EdgeList& edges,
                                    const std::vector<Material>& materials, Threads threads = {});

} // namespace edgeshade
