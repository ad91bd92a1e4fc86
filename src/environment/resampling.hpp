#pragma once

#include "src/environment/octahedral_map.hpp"
#include "src/environment/panorama.hpp"

namespace edgeshade {

/// Resamples the panorama to an octahedral map. Near the poles, where the panorama's texels are
/// smaller, it takes their mean by solid angle, so that a small bright light keeps its power.
/// Elsewhere it filters linearly.
OctahedralMap octahedralFromPanorama(const Panorama& panorama, int size);

} // namespace edgeshade
