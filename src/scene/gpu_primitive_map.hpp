#pragma once

#include "src/gl/float_table.hpp"
#include "src/scene/sided_triangles.hpp"
#include "src/shadow/primitive_map/primitive_map.hpp"

#include <memory>

namespace edgeshade {

/// SidedTriangles on the GPU.
struct SidedChunk {
    float lightSide = 0.0f;
    gl::Buffer vertices; ///< SidedVertex; this and the next are there if `lightSide` is 0
    gl::Buffer details;  ///< SurfaceDetail; none where the material needs none
    gl::Buffer indices;  ///< 16-bit
};

/// Alpha alone, to be looked up texel by texel.
struct AlphaTexture {
    gl::Texture texture;
    glm::vec2 size{1.0f}; ///< in texels
    std::size_t bytes = 0;
};

/// A primitive map on the GPU, with what surfaces need to look themselves up in it.
struct GpuPrimitiveMap {
    using Kind = PrimitiveMapKind;

    Kind kind = Kind::directional;
    glm::dmat4 mapFromWorld{1.0};
    float size = 0.0f;     ///< texels along a tile's edge
    bool extended = false; ///< of a light with an extent: its points are counted
    int longestList = 0;   ///< or more: a power of 2, so that there are few programs
    gl::FloatTable header, entries, records;
    std::shared_ptr<const AlphaTexture> cutouts; ///< null: none of them is alpha-tested
    std::vector<std::vector<SidedChunk>> sided;  ///< by batch, by chunk; none where animated

    std::size_t bytes() const;
};

/// Throws Error(unavailable) if the GL can't.
AlphaTexture uploadAlpha(std::span<const std::uint8_t> alpha, int width, int height);

/// `cutouts`: of the atlas that the map was built with; null where there was none. Throws
/// Error(unavailable) if the GL can't.
GpuPrimitiveMap uploadPrimitiveMap(const PrimitiveMap& map,
                                   const std::vector<std::vector<SidedTriangles>>& triangles,
                                   std::shared_ptr<const AlphaTexture> cutouts,
                                   const gl::Capabilities& capabilities);

} // namespace edgeshade
