#pragma once

#include "src/shadow/geometry/light.hpp"

namespace edgeshade {

/// A light that may be anywhere around, as an extent has it: what is known of all of the extent is
/// so wherever in it the light is. `radius`: > 0; radians of a directional light, at most pi / 4,
/// scene units of others.
Light anywhereWithin(const Light& light, double radius);

/// Whether a light is at such a one's place, or within `share` of the way to its rim, 0 to 1, and
/// reaches as far.
bool isWithin(const Light& light, const Light& region, double share);

} // namespace edgeshade
