#pragma once

#include "preprocess/mesh/components.hpp"
#include "preprocess/mesh/topology.hpp"
#include "preprocess/scene/scene.hpp"

namespace edgeshade {

/// Caps that a part of a cluster holds.
inline constexpr std::uint32_t leafTriangles = 32;

/// Triangles at which a cluster is full: small components share one.
inline constexpr std::size_t clusterTriangles = 512;

/// Whole components that lie near each other and are alike: all closed and opaque, or none.
struct TriangleCluster {
    Box bounds;
    bool closed = false;
    bool alphaTested = false; ///< some triangle is not opaque; never closed then
    std::uint32_t components = 0;
    std::uint32_t singleSided = 0; ///< how many of its triangles, which are the first, have no back
    ItemRange triangles, edges;    ///< of TriangleClusters
};

struct TriangleClusters {
    std::vector<TriangleCluster> clusters;
    /// Cluster after cluster; in each single-sided ones first, then the others; either alpha-tested
    /// and ascending, or along a Morton curve.
    std::vector<std::uint32_t> triangles;
    std::vector<std::uint32_t> edges; ///< each where its first opposite vertex's triangle is
};

/// By component: whether it counts as closed (docs/method.md, C8): it is, and all of it is opaque.
std::vector<std::uint8_t> countsHalf(const CasterMesh& mesh, const Components& components,
                                     const std::vector<Material>& materials);

/// Divides a batch's casters: closed clusters first, then open ones, then alpha-tested ones; within
/// these along a Morton curve.
TriangleClusters clusterTrianglesOf(const CasterMesh& mesh, const EdgeList& edges,
                                    const std::vector<Material>& materials, Threads threads = {});

} // namespace edgeshade
