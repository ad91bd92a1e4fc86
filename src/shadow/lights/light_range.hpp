#pragma once

#include "preprocess/scene/scene.hpp"

#include <array>

namespace edgeshade {

/// What ranges are taken to be longer by, against rounding.
inline constexpr double rangeWidening = 1.0 + 1e-5;

/// Whether everything in the box, which is in an object's space, is farther from a light there than
/// the range in the world. `range`: as rangeInObject() has it.
bool isBeyond(const Box& box, const glm::dvec3& light, double range);

/// The same of a triangle's corners.
bool areBeyond(const std::array<glm::dvec3, 3>& corners, const glm::dvec3& light, double range);

} // namespace edgeshade
