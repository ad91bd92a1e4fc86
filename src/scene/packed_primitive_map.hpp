#pragma once

#include "src/shadow/primitive_map/primitive_map.hpp"

#include <array>

namespace edgeshade {

/// A primitive map in one table, in the format of primitive_map_table.glsl. Header and entries are
/// stored two to a texel; header, entries and records each start at a whole texel. For lights
/// without an extent. Cutouts have textures of their own, among the records.
struct PackedPrimitiveMap {
    PrimitiveMapKind kind = PrimitiveMapKind::directional;
    glm::dmat4 mapFromWorld{1.0};
    int size = 0; ///< texels along a tile's edge
    std::size_t longestList = 0;
    std::array<std::size_t, 2> begins{}; ///< first texels of entries and records
    std::size_t count = 0;               ///< number of texels
    std::vector<glm::vec4> texels;       ///< empty if they are stored elsewhere
};

PackedPrimitiveMap packedPrimitiveMap(const PrimitiveMap& map);

} // namespace edgeshade
