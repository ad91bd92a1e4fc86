#pragma once

#include "edgeshade/shadow_masks.hpp"
#include "src/shadow/lights/light.hpp"

#include <span>
#include <vector>

namespace edgeshade {

/// Converts a host's lights to the planner's. Throws InputError that names the light and the field.
std::vector<Light> lightsOf(std::span<const MaskLight> lights);

} // namespace edgeshade
