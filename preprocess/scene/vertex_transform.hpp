#pragma once

#include <glm/glm.hpp>

namespace edgeshade {

/// Transforms normals, also for mirrored and singular matrices: the cofactors are the inverse
/// transpose times the determinant. Unit length; 0 where there is no direction.
glm::vec3 transformedNormal(const glm::dmat3& matrix, const glm::dvec3& normal);

/// Transforms tangents, w the bitangent's sign: where a mirror turns triangles over, bitangents
/// turn with them. Unit length and 1 or -1; 0 where there is no direction.
glm::vec4 transformedTangent(const glm::dmat3& matrix, const glm::dvec3& tangent, float sign);

/// That of a triangle, counter-clockwise seen from its outside; 0 where it has no area.
glm::vec3 faceNormal(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

} // namespace edgeshade
