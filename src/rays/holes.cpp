#include "src/rays/holes.hpp"

namespace edgeshade::rays {

Holes::Holes(const Scene& scene, const std::vector<SurfaceTriangle>& triangles, IsHole isHole)
    : isHole_(std::move(isHole)) {
    if (!isHole_) return;
    for (const SurfaceTriangle& triangle : triangles)
        mayHave_.push_back(scene.materials[triangle.material].alphaMode == AlphaMode::mask);
}

bool Holes::isMet(const SurfaceTriangle& triangle, const glm::dvec3& origin,
                  const glm::dvec3& direction) const {
    // Moeller and Trumbore 1997.
    const glm::dvec3 ab = triangle.b - triangle.a, ac = triangle.c - triangle.a,
                     s = origin - triangle.a;
    const glm::dvec3 p = glm::cross(direction, ac), q = glm::cross(s, ab);
    const double determinant = glm::dot(ab, p);
    if (determinant == 0.0) return false;
    return isHole_(triangle, glm::dot(s, p) / determinant, glm::dot(direction, q) / determinant);
}

} // namespace edgeshade::rays
