#pragma once

#include <algorithm>
#include <glm/glm.hpp>

namespace edgeshade {

/// The largest factor by which an affine transform without shear stretches lengths.
inline double longestAxis(const glm::dmat4& matrix) {
    const glm::dmat3 axes(matrix);
    return std::max({glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2])});
}

} // namespace edgeshade
