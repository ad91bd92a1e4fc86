#pragma once

#include "src/render/shadow_map/shadow_map.hpp"
#include "src/shadow/lights/light.hpp"

#include <string>

namespace edgeshade {

/// Which map the light gets, for people: "up to 4 cascades of 2048 x 2048 texels, exponential, 5
/// wide".
std::string mapWords(const Light& light, const ShadowMapSettings& settings);

} // namespace edgeshade
