#include "src/shadow/lights/light_cone.hpp"

#include "src/shadow/geometry/vectors.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade {
namespace {

constexpr int sides = 8;              // of the pyramid around a cone
constexpr double widestPyramid = 1.4; // radians, 80 degrees: a wider pyramid contains far too much
constexpr double widening = 1.0 + 1e-5; // factor of an angle, against rounding

double widened(const Cone& cone) {
    return std::min(cone.outer * widening, 0.5 * std::numbers::pi);
}

/// The direction across the axis to the middle of a side of the pyramid, or, for half-integers, to
/// a corner.
glm::dvec3 towardsSide(const std::array<glm::dvec3, 3>& across, double side) {
    const double angle = 2.0 * std::numbers::pi * side / sides;
    return std::cos(angle) * across[0] + std::sin(angle) * across[1];
}

} // namespace

glm::dmat4 coneFromWorld(const Light& spot) {
    const auto across = axesAlong(spot.cone->axis);
    const glm::dmat3 turn = glm::transpose(glm::dmat3(across[0], across[1], spot.cone->axis));
    glm::dmat4 coneFrom(turn);
    coneFrom[3] = glm::dvec4(-(turn * glm::dvec3(spot.position)), 1.0);
    return coneFrom;
}

ConePlanes planesAround(const Light& spot) {
    const glm::dvec3& axis = spot.cone->axis;
    const auto across = axesAlong(axis);
    const double angle = widened(*spot.cone);
    ConePlanes planes;
    planes.push_back({axis, -glm::dot(axis, glm::dvec3(spot.position))});
    for (int side = 0; side < sides; ++side) {
        const glm::dvec3 inside =
            std::sin(angle) * axis - std::cos(angle) * towardsSide(across, side);
        planes.push_back(glm::dvec4(inside, -glm::dot(inside, glm::dvec3(spot.position))));
    }
    return planes;
}

Ball ballAround(const Light& spot, double reach) {
    const double cosine = std::cos(widened(*spot.cone));
    const double radius = reach * widening;
    const glm::dvec3 light(spot.position);
    // Around the tip and the rim; for a wide cone, around the rim alone.
    if (2.0 * cosine * cosine > 1.0) {
        const double half = 0.5 * radius / cosine;
        return {light + half * spot.cone->axis, half};
    }
    return {light + radius * cosine * spot.cone->axis, radius * std::sqrt(1.0 - cosine * cosine)};
}

bool hasPyramid(const Light& spot) {
    return spot.cone->outer <= widestPyramid;
}

std::array<glm::dvec3, 9> pyramidAround(const Light& spot, double reach) {
    const auto across = axesAlong(spot.cone->axis);
    const double along = reach * widening;
    const double aside = along * std::tan(widened(*spot.cone)) / std::cos(std::numbers::pi / sides);
    const glm::dvec3 light(spot.position);
    std::array<glm::dvec3, 9> corners;
    corners[0] = light;
    for (int side = 0; side < sides; ++side)
        corners[static_cast<std::size_t>(side) + 1] =
            light + along * spot.cone->axis + aside * towardsSide(across, side + 0.5);
    return corners;
}

} // namespace edgeshade
