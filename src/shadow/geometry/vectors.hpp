#pragma once

#include "preprocess/base/vectors.hpp"

#include <array>
#include <cmath>
#include <glm/glm.hpp>

namespace edgeshade {

/// The direction of `v` with length 1; `v` must not be 0. Scaled first, so that no double under- or
/// overflows.
inline glm::dvec3 unitOf(const glm::dvec3& v) {
    return glm::normalize(v / largestComponent(v));
}

/// Right, up and `forward`, which must have length 1.
inline std::array<glm::dvec3, 3> axesAlong(const glm::dvec3& forward) {
    const glm::dvec3 other = std::abs(forward.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, other));
    return {right, glm::cross(right, forward), forward};
}

/// A matrix with these rows.
inline glm::dmat4 fromRows(const glm::dvec4& x, const glm::dvec4& y, const glm::dvec4& z,
                           const glm::dvec4& w = {0.0, 0.0, 0.0, 1.0}) {
    return glm::transpose(glm::dmat4(x, y, z, w));
}

} // namespace edgeshade
