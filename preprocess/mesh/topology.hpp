#pragma once

#include "preprocess/mesh/edges.hpp"
#include "preprocess/mesh/weld.hpp"
#include "preprocess/scene/scene.hpp"

namespace edgeshade {

/// The range of caps [firstCap, firstCap + capCount) whose casters have one material.
struct MaterialCasters {
    std::size_t material = 0;
    std::uint32_t firstCap = 0;
    std::uint32_t capCount = 0;
};

/// The casting triangles of a batch, in groups, by their corner indices.
struct Casters {
    std::vector<std::uint32_t> indices; ///< three per triangle, into Batch::positions
    std::vector<SurfaceGroup> groups;   ///< ranges of `indices`
};

/// The casting surfaces of a batch: opaque triangles, and with `castMasked` also MASK and BLEND
/// ones (docs/method.md, C7).
Casters castingSurfacesOf(const Geometry& geometry, const std::vector<Material>& materials,
                          bool castMasked);

/// As castingSurfacesOf(), with simplified casters in place of the opaque triangles where they
/// exist.
Casters castersOf(const Geometry& geometry, const std::vector<Material>& materials,
                  bool castMasked);
inline Casters castersOf(const Batch& batch, const std::vector<Material>& materials,
                         bool castMasked) {
    return castersOf(*batch.geometry, materials, castMasked);
}

/// The number of casting triangles of each batch.
std::vector<std::size_t> casterCounts(const Scene& scene, bool castMasked);

/// Welded casters.
struct CasterMesh {
    WeldedMesh welded;
    std::vector<MaterialCasters> groups; ///< ranges of welded.triangles, and so of caps
};

/// Welds the casters; triangles keep their order.
CasterMesh weldCasters(const Batch& batch, const Casters& casters, Threads threads = {});

/// Welded casters, in groups. `welded`: by weld() of their indices.
CasterMesh inGroups(WeldedMesh welded, const Casters& casters);

/// Welds casters for records that serve all poses. In a deforming batch, vertices are welded if
/// they coincide in every pose (alikeVertices()). Positions are sorted, but may repeat.
CasterMesh weldForRecords(const Batch& batch, const Casters& casters);

/// FNV-1a, 64 bit, over the bytes of every corner's position in order, little-endian. Identifies
/// the surfaces that shadow data belong to; no protection against forgery.
std::uint64_t positionsHash(const Batch& batch, const Casters& surfaces);

} // namespace edgeshade
