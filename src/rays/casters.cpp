#include "src/rays/casters.hpp"

namespace edgeshade::rays {
namespace {

std::vector<Corners> cornersOf(const std::vector<SurfaceTriangle>& triangles) {
    std::vector<Corners> corners;
    corners.reserve(triangles.size());
    for (const SurfaceTriangle& triangle : triangles)
        corners.push_back({triangle.a, triangle.b, triangle.c});
    return corners;
}

std::vector<std::uint32_t> castersOf(const std::vector<SurfaceTriangle>& triangles) {
    std::vector<std::uint32_t> casters;
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
        if (triangles[i].casts) casters.push_back(i);
    return casters;
}

} // namespace

Casters::Casters(const Scene& scene, std::vector<SurfaceTriangle> all, IsHole hole)
    : triangles(std::move(all)), corners(cornersOf(triangles)), isHole(std::move(hole)),
      tree(corners, castersOf(triangles)) {
    if (!isHole) return;
    for (const SurfaceTriangle& triangle : triangles)
        mayHaveHoles.push_back(scene.materials[triangle.material].alphaMode == AlphaMode::mask);
}

bool Casters::isHoleAt(std::uint32_t triangle, const glm::dvec3& origin,
                       const glm::dvec3& direction) const {
    // Moeller and Trumbore 1997.
    const SurfaceTriangle& of = triangles[triangle];
    const glm::dvec3 ab = of.b - of.a, ac = of.c - of.a, s = origin - of.a;
    const glm::dvec3 p = glm::cross(direction, ac), q = glm::cross(s, ab);
    const double determinant = glm::dot(ab, p);
    if (determinant == 0.0) return false;
    return isHole(of, glm::dot(s, p) / determinant, glm::dot(direction, q) / determinant);
}

} // namespace edgeshade::rays
