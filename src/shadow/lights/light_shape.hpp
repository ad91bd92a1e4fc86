#pragma once

#include "src/shadow/lights/light.hpp"

#include <array>

namespace edgeshade {

/// All points of a light, in any space, homogeneous: center + arms * u with |u| <= 1 if it is
/// round, otherwise with every |u_i| <= 1. For a directional light these are directions of any
/// length.
struct LightShape {
    glm::dvec4 center{0.0};
    glm::dmat3 arms{0.0}; ///< 0: a single point
    bool round = true;

    /// The largest deviation of dot(normal, point) from its value at the centre.
    double support(const glm::dvec3& normal) const;
    /// The same shape in another space.
    LightShape in(const glm::dmat4& space) const;
};

/// Whether two lights cast the same shadows: their position, range and extent are equal.
bool castAlike(const Light& a, const Light& b);

/// The side of a triangle that all of a light is on, in one space: 1 if it sees the triangle
/// counter-clockwise, -1 if clockwise, 0 if on neither or uncertain for rounding.
int sideOfAll(const std::array<glm::dvec3, 3>& corners, const LightShape& light);

} // namespace edgeshade
