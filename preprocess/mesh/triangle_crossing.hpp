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

/// Whether any two of these triangles share more than a contact. Also true if deciding would take
/// long: more than a few hundred pairs per triangle have overlapping boxes. A crossing too small to
/// tell from a contact counts as a contact.
bool mayCross(std::vector<TriangleCorners> triangles);

} // namespace edgeshade
