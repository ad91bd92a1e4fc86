#pragma once

#include "src/shadow/primitive_map/primitive_map.hpp"
#include "src/shadow/primitive_map/ray_square.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace edgeshade {

/// The texels of a primitive map's tile in which points may be looked up.
class WantedTexels {
  public:
    /// Those that may have rays to the triangles, and their neighbours up to 8. `size`:
    /// PrimitiveMapSettings::size; the triangles are in the world.
    WantedTexels(const LightTiles& tiles, std::size_t tile, int size,
                 std::span<const WorldTriangle> triangles);

    /// Whether any texel of a square is wanted, from (x, y) on.
    bool anyIn(int x, int y, int side) const;

  private:
    /// Cells along the tile's edge, and texels along a cell's.
    int cells_, cellSide_;
    std::vector<std::uint8_t> wanted_; ///< by cell, row by row
};

} // namespace edgeshade
