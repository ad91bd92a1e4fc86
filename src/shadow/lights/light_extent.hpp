#pragma once

#include "src/shadow/lights/light.hpp"
#include "src/shadow/lights/light_ball.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace edgeshade {

/// Lights with an extent, as points: shadows of all of them together are soft (docs/method.md,
/// C41).

inline constexpr std::size_t mostLightPoints = 4096;

/// The points that stand for the light, itself without its extent: the first `count` of a fixed
/// sequence (quasirandom.hpp) that fills the extent evenly however many are taken. The first one is
/// the centre. Seen from anywhere, a sphere's fill its disc evenly, as a sphere does that is as
/// bright from all sides. `count`: 1 to mostLightPoints; `light`: with an extent, and as its shape
/// wants it, see LightExtent. A rectangle's shine to one side: as spots, where the light is none.
std::vector<Light> lightPoints(const Light& light, std::size_t count);

/// Across and up a rectangle that faces there, of length 1, its width level.
std::array<glm::dvec3, 2> rectangleAxes(const glm::dvec3& direction);

/// Where all of a light's points are, in the world: homogeneous coordinates no farther from
/// `center` than `radius`; of directional lights those of length 1.
struct LightRegion {
    glm::dvec4 center{0.0};
    double radius = 0.0;
};

LightRegion regionOf(const Light& light);

/// A ball that holds lightInObject() of every light in the region, its rounding included.
LightBall ballInObject(const LightRegion& region, const glm::dmat4& worldFromObject);

} // namespace edgeshade
