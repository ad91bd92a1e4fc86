#pragma once

#include "src/city/city_tile.hpp"

#include <span>

namespace edgeshade::city {

/// Adds triangles to a tile: puts corners onto the lattice, and checks their range. Triangles
/// without area are left out.
class TileWriter {
  public:
    explicit TileWriter(CityTile& tile) : tile_(tile) {}

    /// The number of a new object.
    std::uint32_t addObject(std::string id, bool isBuilding);
    /// `where`: begins messages, such as "'a.city.json': CityObjects.b1". Throws InputError for a
    /// corner that is not finite or too far away, and for a triangle that is too large
    /// (lattice.hpp).
    void addTriangle(const std::array<glm::dvec3, 3>& corners, std::uint32_t object,
                     SurfaceKind kind, const std::string& where);

  private:
    CityTile& tile_;
};

} // namespace edgeshade::city
