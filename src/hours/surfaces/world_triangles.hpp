#pragma once

#include "preprocess/scene/scene.hpp"

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

namespace edgeshade::hours {

/// A triangle of the scene in the world.
struct WorldTriangle {
    glm::dvec3 a{0.0}, b{0.0}, c{0.0}; ///< counter-clockwise as seen from its front
    std::uint32_t batch = 0;
    std::uint32_t firstIndex = 0; ///< of its corners, in Geometry::indices
    std::uint32_t node = 0;       ///< index in the file
    std::uint32_t material = 0;   ///< index in the file
};

/// The normal of its front; its length is twice the area.
inline glm::dvec3 normalOf(const WorldTriangle& triangle) {
    return glm::cross(triangle.b - triangle.a, triangle.c - triangle.a);
}

inline double areaOf(const WorldTriangle& triangle) {
    return 0.5 * glm::length(normalOf(triangle));
}

/// Whether the surfaces of a node and a material, by their indices in the file, are chosen.
using SurfaceChoice = std::function<bool(std::uint32_t node, std::uint32_t material)>;

/// Chosen triangles, batch after batch in the order of their indices, without those of the ground
/// and of hidden batches. Mirrored batches keep their fronts.
std::vector<WorldTriangle> worldTriangles(const Scene& scene, const SurfaceChoice& choice);

} // namespace edgeshade::hours
