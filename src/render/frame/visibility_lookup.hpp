#pragma once

#include "src/gl/objects.hpp"

#include <glm/glm.hpp>

namespace edgeshade {

/// The visible share of a light with an extent for each pixel's surface, as light.glsl reads it.
struct VisibilityLookup {
    gl::Name texture = 0; ///< 0: nothing was counted
    glm::vec2 size{1.0f}; ///< in pixels
};

} // namespace edgeshade
