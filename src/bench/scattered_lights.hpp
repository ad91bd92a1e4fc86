#pragma once

#include "preprocess/scene/scene.hpp"
#include "src/shadow/lights/light.hpp"

#include <vector>

namespace edgeshade::bench {

/// Around each place of the floor, on the average, this many of scatterLights()' lights reach.
inline constexpr double overlappingLights = 4.0;

/// So many point lights over a scene's surfaces, the same on every machine: evenly over what faces
/// up by area (over all surfaces where nothing does), a quarter of their range above it, of many
/// hues, in candela. Their range is what has overlappingLights of them reach a place whatever their
/// number, and no more than the scene's diagonal: of more lights each reaches less.
std::vector<Light> scatterLights(const Scene& scene, std::size_t count);

} // namespace edgeshade::bench
