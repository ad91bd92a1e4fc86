#pragma once

#include "preprocess/base/box.hpp"
#include "src/shadow/lights/light.hpp"

#include <array>
#include <vector>

namespace edgeshade {

/// Of spots: where their light goes, in shapes that hold all of it and little more.

/// From the world to the cone: the light at 0, its axis along z. A point is lit where length(xy) <
/// tan(outer) z.
glm::dmat4 coneFromWorld(const Light& spot);

/// Planes through the light all around its cone, in the world: what is lit is where dot(plane, (p,
/// 1)) >= 0 of every one.
std::vector<glm::dvec4> planesAround(const Light& spot);

/// A ball, in the world.
struct Ball {
    glm::dvec3 center;
    double radius;
};

/// Around what of the cone is no farther than `reach` from the light.
Ball ballAround(const Light& spot, double reach);

/// The corners of a pyramid around the same. Only for cones that are not too wide for one, see
/// hasPyramid().
std::array<glm::dvec3, 9> pyramidAround(const Light& spot, double reach);
bool hasPyramid(const Light& spot);

} // namespace edgeshade
