#pragma once

#include "src/shadow/primitive_map/primitive_map.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace edgeshade {

/// The texels of a primitive map's tile in which points may be looked up.
class WantedTexels {
  public:
    /// Those that may have rays to the triangles. `size`: PrimitiveMapSettings::size; the triangles
    /// are in the world.
    WantedTexels(const LightTiles& tiles, std::size_t tile, int size,
                 std::span<const WorldTriangle> triangles);

    /// Whether any texel of a square is wanted, from (x, y) on.
    bool anyIn(int x, int y, int side) const;

  private:
    void add(const RaySquare& rays);
    std::uint32_t& sumAt(int x, int y);
    std::uint32_t sumAt(int x, int y) const;

    int size_;
    /// How many of the texels below and left of each corner are wanted, row by row.
    std::vector<std::uint32_t> sums_;
};

} // namespace edgeshade
