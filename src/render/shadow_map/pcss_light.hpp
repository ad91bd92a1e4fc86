#pragma once

#include "src/shadow/lights/light.hpp"

namespace edgeshade {

/// A light's extent, as percentage-closer soft shadows use it with the map of the light's centre
/// (shaders_es2/pcss.glsl). Map space: see ShadowMapView.
struct PcssLight {
    LightExtent::Shape shape = LightExtent::Shape::sphere;
    float radius = 0.0f;              ///< a sphere's radius in map space; a disc's is the tangent
                                      ///< of its angle
    glm::vec3 across{0.0f}, up{0.0f}; ///< half edges of a rectangle, in map space
    glm::vec3 facing{0.0f};           ///< a rectangle's direction, of length 1
    float leastSpread = 0.0f;         ///< the extent that makes a penumbra one texel wide; for
                                      ///< cubes at distance 1
    float nearestCaster = 0.0f;       ///< point lights only, in map space
};

} // namespace edgeshade
