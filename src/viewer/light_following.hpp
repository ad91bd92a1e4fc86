#pragma once

#include "src/shadow/lights/light.hpp"

#include <vector>

namespace edgeshade::viewer {

/// Lets lights go with the nodes that carry them. `before` and `now`: the file's lights, one for
/// one; what of `lights` is one of them, as it was or as it is, becomes the one that is now. What a
/// user has moved or changed is theirs, and stays. Lights are the same where texts of them are,
/// with some six digits: what an address kept goes on moving.
void followLights(std::vector<Light>& lights, const std::vector<Light>& before,
                  const std::vector<Light>& now);

} // namespace edgeshade::viewer
