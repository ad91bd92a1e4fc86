#pragma once

#include "src/environment/octahedral_map.hpp"
#include "src/environment/panorama.hpp"

namespace edgeshade {

/// The panorama on an octahedral map: where its texels are the smaller ones, near the poles, their
/// mean by solid angle, so that a small bright light keeps its power; between them filtered
/// linearly.
OctahedralMap octahedralFromPanorama(const Panorama& panorama, int size);

} // namespace edgeshade
