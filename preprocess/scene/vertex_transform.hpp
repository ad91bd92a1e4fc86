#pragma once

#include <glm/glm.hpp>

namespace edgeshade {

/// Transforms normals, also by mirroring and singular matrices: it uses the cofactors, which are
/// the inverse transpose times the determinant. Unit length; 0 if there is no direction.
glm::vec3 transformedNormal(const glm::dmat3& matrix, const glm::dvec3& normal);

/// Transforms tangents, with the bitangent's sign in w, which changes with a mirroring matrix. Unit
/// length and 1 or -1; 0 if there is no direction.
glm::vec4 transformedTangent(const glm::dmat3& matrix, const glm::dvec3& tangent, float sign);

/// Normal of a triangle that is counter-clockwise as seen from outside; 0 if it has no area.
glm::vec3 faceNormal(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

} // namespace edgeshade
