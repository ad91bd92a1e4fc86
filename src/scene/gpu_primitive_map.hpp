#pragma once

#include "src/gl/float_table.hpp"
#include "src/scene/surface_parts.hpp"
#include "src/shadow/primitive_map/primitive_map.hpp"

#include <memory>

namespace edgeshade {

/// A chunk's triangles anew: some that are turned away from a light, those that face it, the others
/// that are turned away. Their order within each is kept, and of triangles that coincide the first
/// one stays before the others: it is the one that is seen.
struct SortedTriangles {
    std::vector<std::uint16_t> indices;
    std::size_t before = 0; ///< indices of the first kind
    std::size_t facing = 0; ///< and of the second
};

/// Of every chunk of a batch, for a light in the batch's space.
std::vector<SortedTriangles> sortedByFacing(const Batch& batch, const glm::dvec4& light);

/// The same on the GPU.
struct FacingIndices {
    gl::Buffer indices;
    int before = 0, facing = 0, after = 0; ///< as SortedTriangles has them
};

/// A primitive map on the GPU, with what surfaces need to look themselves up in it.
struct GpuPrimitiveMap {
    enum class Kind { directional, oneTile, sixTiles };

    Kind kind = Kind::directional;
    glm::dmat4 mapFromWorld{1.0};
    float size = 0.0f;   ///< texels along a tile's edge
    int splits = 0;      ///< PrimitiveMap::splits
    int longestList = 0; ///< or more: a power of 2, so that there are few programs
    gl::FloatTable header, entries, records;
    std::vector<std::vector<FacingIndices>> facings; ///< by batch, by chunk; none where animated

    std::size_t bytes() const;
};

/// Throws Error(unavailable) if the GL can't.
GpuPrimitiveMap uploadPrimitiveMap(const PrimitiveMap& map,
                                   const std::vector<std::vector<SortedTriangles>>& triangles,
                                   const gl::Capabilities& capabilities);

} // namespace edgeshade
