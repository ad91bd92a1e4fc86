#pragma once

#include "preprocess/scene.hpp"

#include <glm/glm.hpp>

namespace edgeshade {

/// A light in the world (method, section 1): w = 1, a point light at xyz; w = 0, a sun, xyz
/// pointing towards it.
struct Light {
    glm::dvec4 position{0.0, 1.0, 0.0, 0.0};
};

/// A sun that suits any scene, high and from the side.
Light defaultLight();

/// The light in an object's space, computed in double and rounded once. `worldFromObject` must be
/// invertible.
glm::vec4 lightInObject(const Light& light, const glm::dmat4& worldFromObject);

} // namespace edgeshade
