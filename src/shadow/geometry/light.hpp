#pragma once

#include "preprocess/scene/scene.hpp"

#include <cmath>
#include <glm/glm.hpp>
#include <limits>

namespace edgeshade {

/// Lights that one frame can have.
inline constexpr std::size_t mostLights = 32;

/// Throws Error(usage) for more than those.
void requireFewLights(std::size_t lights);

/// A light in the world (docs/method.md, Terms): w = 1, a point light at xyz; w = 0, a directional
/// light, xyz pointing towards it.
struct Light {
    glm::dvec4 position{0.0, 1.0, 0.0, 0.0};
    /// Scene units, above 0: a point light gets no farther. Within d of it Lambert's law is weighed
    /// by max(1 - (d / range)^4, 0), the window that KHR_lights_punctual recommends. Directional
    /// lights have none.
    double range = std::numeric_limits<double>::infinity();

    bool hasRange() const { return position.w != 0.0 && std::isfinite(range); }
};

/// A directional light that suits any scene, high and from the side.
Light defaultLight();

/// The light in an object's space, computed in double and rounded once. `worldFromObject` must be
/// invertible.
glm::vec4 lightInObject(const Light& light, const glm::dmat4& worldFromObject);

} // namespace edgeshade
