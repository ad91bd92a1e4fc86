#pragma once

#include "src/shadow/primitive_map/primitive_map.hpp"

#include <array>
#include <span>

namespace edgeshade {

/// A primitive map in one table, in the format of primitive_map_table.glsl. Header and entries are
/// stored two to a texel; header, entries and records each start at a whole texel. Cutouts have
/// textures of their own, among the records. A light with an extent has its points behind the
/// records, in map space: its middle (homogeneous), the columns of its arms (LightShape) with the
/// number of points behind the first, and for each sixteen points four texels each of x, y, z and
/// of 1 for a point, 0 for none.
struct PackedPrimitiveMap {
    PrimitiveMapKind kind = PrimitiveMapKind::directional;
    glm::dmat4 mapFromWorld{1.0};
    int size = 0; ///< texels along a tile's edge
    std::size_t longestList = 0;
    std::array<std::size_t, 2> begins{}; ///< first texels of entries and records
    std::size_t places = 0;              ///< first texel of the light's points
    std::size_t sixteens = 0;            ///< of points; 0: the light has no extent
    std::size_t count = 0;               ///< number of texels
    std::vector<glm::vec4> texels;       ///< empty if they are stored elsewhere
};

/// `points`: of a light with an extent, else empty.
PackedPrimitiveMap packedPrimitiveMap(PrimitiveMap map, std::span<const Light> points = {});

} // namespace edgeshade
