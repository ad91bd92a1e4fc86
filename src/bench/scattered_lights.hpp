#pragma once

#include "preprocess/scene/scene.hpp"
#include "src/shadow/lights/light.hpp"

#include <vector>

namespace edgeshade::bench {

/// The average number of scatterLights()' lights that reach a place on the floor.
inline constexpr double overlappingLights = 4.0;

/// `count` point lights over a scene's surfaces, the same on every machine. They are spread evenly
/// by area over surfaces that face up (over all surfaces if none does), a quarter of their range
/// above, in many hues, in candela. Their range lets overlappingLights of them reach a place
/// whatever their number, up to the scene's diagonal: the more lights, the shorter their range.
std::vector<Light> scatterLights(const Scene& scene, std::size_t count);

} // namespace edgeshade::bench
