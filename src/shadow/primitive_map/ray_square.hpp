#pragma once

#include <glm/glm.hpp>

namespace edgeshade {

/// A square or rectangle of rays (x, y, 1) in a tile of a primitive map.
struct RaySquare {
    glm::dvec2 low, high;

    glm::dvec3 corner(int i) const { return {i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, 1.0}; }
    glm::dvec3 center() const { return {0.5 * (low + high), 1.0}; }
    RaySquare grownBy(double margin) const { return {low - margin, high + margin}; }
};

} // namespace edgeshade
