#pragma once

#include "preprocess/base/box.hpp"

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

namespace edgeshade::city {

/// The semantics of a surface, where the file says them.
enum class SurfaceKind : std::uint8_t { none, ground, roof, wall, other };

/// A triangle of a city in the plan's frame: metres east, north and up, on the lattice.
struct CityTriangle {
    std::array<glm::dvec3, 3> corners;
    std::uint32_t object = 0; ///< in CityTile::objects
    SurfaceKind kind = SurfaceKind::none;

    Box box() const {
        Box box;
        for (const glm::dvec3& corner : corners)
            box.add(corner);
        return box;
    }
};

/// An object that cells are summed up by.
struct CityObject {
    std::string id;
    bool isBuilding = false;
};

/// The contents of one source.
struct CityTile {
    std::vector<CityTriangle> triangles;
    std::vector<CityObject> objects;
    std::optional<int> epsg; ///< code of the coordinates, if the source says it
    std::vector<std::string> warnings;
};

} // namespace edgeshade::city
