#pragma once

#include "src/gl/float_table.hpp"
#include "src/scene/sided_triangles.hpp"
#include "src/shadow/primitive_map/primitive_map.hpp"

#include <memory>

namespace edgeshade {

/// SidedTriangles on the GPU.
struct SidedChunk {
    float lightSide = 0.0f;
    gl::Buffer vertices; ///< SidedVertex; vertices and details exist if `lightSide` is 0
    gl::Buffer details;  ///< SurfaceDetail; empty if the material needs none
    gl::Buffer indices;  ///< 16-bit
};

/// An alpha texture, sampled without filtering.
struct AlphaTexture {
    gl::Texture texture;
    glm::vec2 size{1.0f}; ///< in texels
    std::size_t bytes = 0;
};

/// A primitive map on the GPU, with the data that surfaces need to look up their shadow in it.
struct GpuPrimitiveMap {
    using Kind = PrimitiveMapKind;

    Kind kind = Kind::directional;
    glm::dmat4 mapFromWorld{1.0};
    float size = 0.0f;     ///< texels along a tile's edge
    bool extended = false; ///< for a light with an extent: counts its visible points
    int longestList = 0;   ///< rounded up to a power of 2, so that few programs are needed
    gl::FloatTable header, entries, records;
    std::shared_ptr<const AlphaTexture> cutouts; ///< null: no caster is alpha-tested
    std::vector<std::vector<SidedChunk>> sided;  ///< by batch, by chunk; empty for animated batches

    std::size_t bytes() const;
};

/// Throws Error(unavailable) if the GL can't.
AlphaTexture uploadAlpha(std::span<const std::uint8_t> alpha, int width, int height);

/// `cutouts`: the atlas that the map was built with, or null. Throws Error(unavailable) if the GL
/// can't.
GpuPrimitiveMap uploadPrimitiveMap(const PrimitiveMap& map,
                                   const std::vector<std::vector<SidedTriangles>>& triangles,
                                   std::shared_ptr<const AlphaTexture> cutouts,
                                   const gl::Capabilities& capabilities);

} // namespace edgeshade
