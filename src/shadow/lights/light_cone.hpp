#pragma once

#include "preprocess/base/box.hpp"
#include "preprocess/base/inline_vector.hpp"
#include "src/shadow/lights/light.hpp"

#include <array>

namespace edgeshade {

/// Shapes around the light of spots, which hold all of it and little more.

/// Transform from the world to the cone: the light at 0, its axis along z. A point is lit if
/// length(xy) < tan(outer) z.
glm::dmat4 coneFromWorld(const Light& spot);

/// Some planes around a cone.
using ConePlanes = InlineVector<glm::dvec4, 9>;

/// Planes through the light around its cone, in the world: lit points have dot(plane, (p, 1)) >= 0
/// for all of them.
ConePlanes planesAround(const Light& spot);

/// A ball, in the world.
struct Ball {
    glm::dvec3 center;
    double radius;
};

/// A ball around the part of the cone within `reach` of the light.
Ball ballAround(const Light& spot, double reach);

/// The corners of a pyramid around the same part. Only for cones that aren't too wide, see
/// hasPyramid().
std::array<glm::dvec3, 9> pyramidAround(const Light& spot, double reach);
bool hasPyramid(const Light& spot);

} // namespace edgeshade
