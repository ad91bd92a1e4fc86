#pragma once

#include "src/sun/ephemeris.hpp"

#include <glm/glm.hpp>

namespace edgeshade::sun {

/// The unit vector towards the sun in a scene whose +Y is up. `north`: degrees clockwise, seen from
/// above, from the scene's -Z to its north. 0: -Z is north and +X east; glTF's front, +Z, then
/// faces south.
glm::dvec3 towardsSun(const SunPosition& position, double north);

} // namespace edgeshade::sun
