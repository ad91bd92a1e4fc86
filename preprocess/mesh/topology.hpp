#pragma once

#include "preprocess/mesh/edges.hpp"
#include "preprocess/mesh/weld.hpp"
#include "preprocess/scene/scene.hpp"

namespace edgeshade {

/// Caps [firstCap, firstCap + capCount) of casters of one material.
struct MaterialCasters {
    std::size_t material = 0;
    std::uint32_t firstCap = 0;
    std::uint32_t capCount = 0;
};

/// The triangles of a batch that cast: which groups, and their corner indices.
struct Casters {
    std::vector<std::uint32_t> indices; ///< three a triangle, into Batch::positions
    std::vector<SurfaceGroup> groups;   ///< ranges of `indices`
};

/// The surfaces of a batch that cast: opaque triangles, with `castMasked` MASK and BLEND ones too
/// (docs/method.md, C7).
Casters castingSurfacesOf(const Geometry& geometry, const std::vector<Material>& materials,
                          bool castMasked);

/// The same with the simplified casters, where there are some, in place of the opaque triangles.
Casters castersOf(const Geometry& geometry, const std::vector<Material>& materials,
                  bool castMasked);
inline Casters castersOf(const Batch& batch, const std::vector<Material>& materials,
                         bool castMasked) {
    return castersOf(*batch.geometry, materials, castMasked);
}

/// Casters, welded.
struct CasterMesh {
    WeldedMesh welded;
    std::vector<MaterialCasters> groups; ///< ranges of welded.triangles, and so of caps
};

/// Welds the casters; triangles keep their order.
CasterMesh weldCasters(const Batch& batch, const Casters& casters, Threads threads = {});

/// The same for records that last for all poses: of a batch that deforms, vertices are one if they
/// are at one place in whatever pose (alikeVertices()). Positions are sorted, but may repeat.
CasterMesh weldForRecords(const Batch& batch, const Casters& casters);

/// FNV-1a, 64 bit, over the bytes of every corner's position in order, little-endian. Tells
/// whether shadow data belong to these surfaces; no defence against forgery.
std::uint64_t positionsHash(const Batch& batch, const Casters& surfaces);

} // namespace edgeshade
