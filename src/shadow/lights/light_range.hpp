#pragma once

#include "preprocess/scene/scene.hpp"

#include <array>

namespace edgeshade {

/// Factor by which ranges are lengthened, against rounding.
inline constexpr double rangeWidening = 1.0 + 1e-5;

/// Whether the whole box, in an object's space, is beyond the range of a light there. `range`: as
/// of rangeInObject().
bool isBeyond(const Box& box, const glm::dvec3& light, double range);

/// The same for a triangle's corners.
bool areBeyond(const std::array<glm::dvec3, 3>& corners, const glm::dvec3& light, double range);

} // namespace edgeshade
