#pragma once

#include <glm/glm.hpp>

namespace edgeshade {

/// Whether four points lie in one plane, exactly. May answer false for coplanar points whose
/// coordinates along an axis differ in magnitude by more than 2^16 (integers of 128 bits hold the
/// determinant of all others); never true for points that are not.
bool areCoplanar(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d);

} // namespace edgeshade
