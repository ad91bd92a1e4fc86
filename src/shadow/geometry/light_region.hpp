#pragma once

#include "src/shadow/geometry/light.hpp"

namespace edgeshade {

/// Radians between two directional lights, units between two others, infinite between one and
/// another.
double placesApart(const glm::dvec4& a, const glm::dvec4& b);

/// A light that may be anywhere around, as an extent has it: what is known of all of the extent is
/// so wherever in it the light is. `radius`: > 0; radians of a directional light, at most pi / 4,
/// scene units of others.
Light anywhereWithin(const Light& light, double radius);

/// Whether a light is at such a one's place, or within `share` of the way to its rim, 0 to 1, and
/// reaches as far.
bool isWithin(const Light& light, const Light& region, double share);

/// The largest radius within which a fair share of the casters that are in the shadow of others
/// stay so, wherever the light is (docs/measured/fill.md). `sceneSize`: its diagonal.
double mostWander(const Light& light, double sceneSize);

} // namespace edgeshade
