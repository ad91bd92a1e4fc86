#pragma once

#include "src/shadow/lights/light.hpp"

#include <array>

namespace edgeshade {

/// All places that a light shines from, in any space, homogeneous: center + arms * u with |u| <= 1
/// where it is round, else with every |u_i| <= 1. Of a directional light these are directions,
/// which have any length.
struct LightShape {
    glm::dvec4 center{0.0};
    glm::dmat3 arms{0.0}; ///< 0: it is but a point
    bool round = true;

    /// How far dot(normal, place) gets from that of the centre.
    double support(const glm::dvec3& normal) const;
    /// The same shape elsewhere.
    LightShape in(const glm::dmat4& space) const;
};

/// In the world; of a light without an extent its place alone.
LightShape shapeOf(const Light& light);

/// Whether what casts leaves them the same shadows: place, range and extent are alike.
bool castAlike(const Light& a, const Light& b);

/// Which side of a triangle all of a light is on, in one space: 1 where it sees it
/// counter-clockwise; 0: no side, as far as rounding tells.
int sideOfAll(const std::array<glm::dvec3, 3>& corners, const LightShape& light);

} // namespace edgeshade
