#pragma once

#include <glm/glm.hpp>

namespace edgeshade {

/// n · p + d, whose sign is the side of a vertex (docs/method.md, C49). Computed in double in this
/// order, so that it depends on the plane and the position alone.
inline double heightOver(const glm::dvec4& plane, const glm::vec3& point) {
    return plane.x * static_cast<double>(point.x) + plane.y * static_cast<double>(point.y) +
           plane.z * static_cast<double>(point.z) + plane.w;
}

} // namespace edgeshade
