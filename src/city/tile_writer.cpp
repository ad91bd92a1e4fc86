#include "src/city/tile_writer.hpp"

#include "preprocess/base/error.hpp"
#include "src/city/lattice.hpp"

#include <algorithm>
#include <cstdio>

namespace edgeshade::city {
namespace {

std::string textOf(const glm::dvec3& v) {
    char text[120];
    std::snprintf(text, sizeof text, "(%.9g, %.9g, %.9g)", v.x, v.y, v.z);
    return text;
}

/// NaN is not within.
bool isWithin(const glm::dvec3& v) {
    return std::abs(v.x) <= farthestCoordinate && std::abs(v.y) <= farthestCoordinate &&
           std::abs(v.z) <= farthestHeight;
}

} // namespace

std::uint32_t TileWriter::addObject(std::string id, bool isBuilding) {
    tile_.objects.push_back({std::move(id), isBuilding});
    return static_cast<std::uint32_t>(tile_.objects.size() - 1);
}

void TileWriter::addTriangle(const std::array<glm::dvec3, 3>& corners, std::uint32_t object,
                             SurfaceKind kind, const std::string& where) {
    CityTriangle triangle{{}, object, kind};
    for (std::size_t i = 0; i < 3; ++i) {
        if (!isWithin(corners[i]))
            throw InputError(where + " has a corner at " + textOf(corners[i]) +
                             " metres, but a city's coordinates are within 2^29 metres and its "
                             "heights within 2^14.");
        triangle.corners[i] = onLattice(corners[i]);
    }
    const auto& [a, b, c] = triangle.corners;
    if (glm::cross(b - a, c - a) == glm::dvec3(0.0)) return;
    const Box box = triangle.box();
    const glm::dvec3 size = box.high - box.low;
    if (std::max({size.x, size.y, size.z}) > longestTriangle)
        throw InputError(where + " has a triangle that is " + textOf(size) +
                         " metres large, but a city's triangles are at most 8192 metres.");
    tile_.triangles.push_back(triangle);
}

} // namespace edgeshade::city
