#include "src/rays/surface_triangle.hpp"

namespace edgeshade::rays {

std::array<glm::dvec3, 3> cornersInBatch(const SurfaceTriangle& triangle) {
    const Geometry& geometry = *triangle.geometry;
    const auto corner = [&](std::uint32_t i) {
        return glm::dvec3(geometry.positions[geometry.indices[triangle.firstIndex + i]]);
    };
    const glm::dvec3 a = corner(0), b = corner(1), c = corner(2);
    if (!triangle.isCut) return {a, b, c};
    const auto at = [&](const glm::dvec2& place) {
        return a + place.x * (b - a) + place.y * (c - a);
    };
    return {at(triangle.places[0]), at(triangle.places[1]), at(triangle.places[2])};
}

} // namespace edgeshade::rays
