#pragma once

#include "src/lab/pixel_surfaces.hpp"

namespace edgeshade::lab {

/// The number of directions, each pointing towards its light, that light the surface of each pixel,
/// by rays without rounding (docs/method.md, C56): those for which judge() says that it is lit. 0
/// where a pixel shows no surface. `surfaces`: of the oracle's pixels, from pixelSurfaces().
/// `directions`: at most 65,535, none 0. `progress` receives the share done.
std::vector<std::uint16_t> litCounts(const Oracle& oracle, std::span<const PixelSurface> surfaces,
                                     std::span<const glm::dvec3> directions,
                                     const std::function<void(double)>& progress);

} // namespace edgeshade::lab
