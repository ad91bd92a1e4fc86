#pragma once

#include "preprocess/scene.hpp"

#include <array>
#include <glm/glm.hpp>

namespace edgeshade {

/// The hull of a rectangle and a light: a pyramid, or for a sun (w = 0) a prism that is drawn out
/// towards it to infinity.
struct LightPyramid {
    std::array<glm::dvec3, 4> corners; ///< of the rectangle, or any parallelogram, in turn
    glm::dvec4 light;                  ///< method, section 1
};

/// Whether pyramid and box are certainly apart: some axis separates them by more than rounding.
bool areApart(const LightPyramid& pyramid, const Box& box);

/// The same of a triangle.
bool areApart(const LightPyramid& pyramid, const std::array<glm::dvec3, 3>& triangle);

} // namespace edgeshade
