#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace edgeshade {

/// The largest magnitude of a component.
inline double largestComponent(const glm::dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

inline bool isFinite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

inline bool isFinite(const glm::dmat4& matrix) {
    for (glm::length_t column = 0; column < 4; ++column)
        if (!isFinite(glm::dvec3(matrix[column])) || !std::isfinite(matrix[column].w)) return false;
    return true;
}

} // namespace edgeshade
