#pragma once

#include "preprocess/scene/scene.hpp"

#include <glm/glm.hpp>
#include <vector>

namespace edgeshade {

/// Planes with everything between a light and a box on their inner sides: dot(plane, (p, 1)) >= 0,
/// up to rounding, at each point p of each segment from the light to the box. A box that is outside
/// one of them (isOutside()) casts no shadow on anything in the box. `light`: homogeneous. None for
/// an empty box. Fills `planes`, and keeps its memory.
void findPlanesBetween(const glm::dvec4& light, const Box& box, std::vector<glm::dvec4>& planes);

} // namespace edgeshade
