#pragma once

#include "preprocess/mesh/weld.hpp"

#include <array>
#include <glm/glm.hpp>
#include <vector>

namespace edgeshade {

using TriangleCorners = std::array<glm::dvec3, 3>;

inline TriangleCorners cornersOf(const WeldedMesh& mesh, std::size_t triangle) {
    const Triangle& of = mesh.triangles[triangle];
    return {glm::dvec3(mesh.positions[of[0]]), glm::dvec3(mesh.positions[of[1]]),
            glm::dvec3(mesh.positions[of[2]])};
}

/// Whether some two of these triangles have more in common than a contact, or it would take long to
/// tell: more than some hundred pairs a triangle whose boxes overlap. What rounding can't tell from
/// a contact is one.
bool mayCross(std::vector<TriangleCorners> triangles);

} // namespace edgeshade
