#pragma once

#include "src/shadow/lights/light.hpp"
#include "src/shadow/lights/light_ball.hpp"
#include "src/shadow/lights/light_shape.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace edgeshade {

/// Most points of a light with an extent. Their shadows together are soft (docs/method.md, C41).
inline constexpr std::size_t mostLightPoints = 4096;

/// Points that stand for the light, each a copy of it without its extent. They are the first
/// `count` of a fixed sequence (quasirandom.hpp) that fills the extent evenly at every length. The
/// first one is the centre. Seen from anywhere, the points of a sphere fill its disc evenly, like a
/// uniformly bright sphere. `count`: 1 to mostLightPoints; `light`: with an extent that meets the
/// conditions of LightExtent. Points of a rectangle shine to one side: as spots, unless the light
/// is one.
std::vector<Light> lightPoints(const Light& light, std::size_t count);
void findLightPoints(const Light& light, std::size_t count, std::vector<Light>& points);

/// Unit vectors across and up a rectangle that faces `direction`, with its width level.
std::array<glm::dvec3, 2> rectangleAxes(const glm::dvec3& direction);

/// All of a light's points in the world; for a light without an extent, its position alone.
LightShape shapeOf(const Light& light);

/// A region that holds all of a light's points, in the world: homogeneous coordinates within
/// `radius` of `center`; for directional lights, of length 1.
struct LightRegion {
    glm::dvec4 center{0.0};
    double radius = 0.0;
};

LightRegion regionOf(const Light& light);

/// A ball that holds lightInObject() of every light in the region, with its rounding.
LightBall ballInObject(const LightRegion& region, const glm::dmat4& worldFromObject);

} // namespace edgeshade
