#pragma once

#include "src/gl/objects.hpp"

#include <glm/glm.hpp>

namespace edgeshade {

/// How much of a light with an extent is seen from what each pixel shows, as light.glsl reads it.
struct VisibilityLookup {
    gl::Name texture = 0; ///< 0: nobody has counted
    glm::vec2 size{1.0f}; ///< pixels
};

} // namespace edgeshade
