#pragma once

#include "src/shadow/lights/light.hpp"

#include <vector>

namespace edgeshade::viewer {

/// Moves lights with the nodes that carry them. `before` and `now`: the file's lights, in the same
/// order. A light of `lights` that equals one of either becomes the one in `now`; a light that a
/// user has moved or changed stays. Lights count as equal if they agree to about five digits, so
/// that lights restored from an address keep moving.
void followLights(std::vector<Light>& lights, const std::vector<Light>& before,
                  const std::vector<Light>& now);

} // namespace edgeshade::viewer
