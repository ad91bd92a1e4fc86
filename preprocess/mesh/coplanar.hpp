#pragma once

#include <glm/glm.hpp>

namespace edgeshade {

/// Whether four points lie in one plane, decided exactly. May return false for coplanar points
/// whose coordinates along an axis differ in magnitude by more than 2^16 (128-bit integers hold the
/// determinant of all others). Never returns true for other points.
bool areCoplanar(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d);

} // namespace edgeshade
