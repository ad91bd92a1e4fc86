#pragma once

#include <glm/glm.hpp>

namespace edgeshade {

/// A light's extent as percentage-closer soft shadows look for it in the map of its centre
/// (shaders_es2/pcss.glsl). Map space: see ShadowMapView.
struct PcssLight {
    bool rectangle = false;
    float radius = 0.0f;              ///< of a sphere, in map space; of a disc its angle's tangent
    glm::vec3 across{0.0f}, up{0.0f}; ///< halves of a rectangle, in map space
    glm::vec3 facing{0.0f};           ///< where a rectangle does, of length 1
    float leastSpread = 0.0f;         ///< what makes a penumbra as wide as a texel; of cubes at 1
    float nearestCaster = 0.0f;       ///< of a point light, in map space
};

} // namespace edgeshade
