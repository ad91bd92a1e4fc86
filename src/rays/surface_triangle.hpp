#pragma once

#include "preprocess/scene/scene.hpp"

#include <array>
#include <glm/glm.hpp>

namespace edgeshade::rays {

/// A triangle of the scene relative to one place, such as the eye: world axes, with the origin
/// there, so that triangles nearby keep their detail anywhere in the world.
struct SurfaceTriangle {
    glm::dvec3 a{0.0}, b{0.0}, c{0.0};
    std::uint32_t batch = 0;
    std::uint32_t firstIndex = 0; ///< of its corners, in Geometry::indices
    std::uint32_t material = 0;
    const Geometry* geometry = nullptr; ///< that has its corners; the scene owns it
    /// The corners' coordinates in the geometry's triangle, of its second and third corner; other
    /// than these where a section cuts it.
    std::array<glm::dvec2, 3> places = {glm::dvec2(0.0), glm::dvec2(1.0, 0.0),
                                        glm::dvec2(0.0, 1.0)};
    bool isCut = false;  ///< a section cuts it
    bool casts = true;   ///< blocks light
    bool visible = true; ///< false for BLEND, and for backs that the scene culls
};

/// Its corners in its batch's space: the scene's floats, or points between them where a section
/// cuts it.
std::array<glm::dvec3, 3> cornersInBatch(const SurfaceTriangle& triangle);

/// Coordinates (u, v) of a triangle as those of the geometry's triangle.
inline glm::dvec2 placeInGeometry(const SurfaceTriangle& triangle, const glm::dvec2& place) {
    const auto& [a, b, c] = triangle.places;
    return a + place.x * (b - a) + place.y * (c - a);
}

/// Its normal, by the order of its corners; its length is twice the area.
inline glm::dvec3 normalOf(const SurfaceTriangle& triangle) {
    return glm::cross(triangle.b - triangle.a, triangle.c - triangle.a);
}

} // namespace edgeshade::rays
