#pragma once

#include "src/shadow/primitive_map/primitive_map.hpp"

#include <array>

namespace edgeshade {

/// A primitive map in one table, as primitive_map_table.glsl reads it: header and entries two a
/// texel, each of the three from a whole texel on. Of a light without an extent, without cutouts.
struct PackedPrimitiveMap {
    PrimitiveMapKind kind = PrimitiveMapKind::directional;
    glm::dmat4 mapFromWorld{1.0};
    int size = 0; ///< texels along a tile's edge
    std::size_t longestList = 0;
    std::array<std::size_t, 2> begins{}; ///< texels at which entries and records begin
    std::size_t count = 0;               ///< of texels
    std::vector<glm::vec4> texels;       ///< or none: somebody else has them
};

PackedPrimitiveMap packedPrimitiveMap(const PrimitiveMap& map);

} // namespace edgeshade
