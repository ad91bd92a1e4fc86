#pragma once

#include "src/settings/settings.hpp"
#include "src/shadow/view/frustum.hpp"

#include <cstdint>

namespace edgeshade {

inline constexpr std::size_t mostSubpixels = settings::smooth.domain.high;

/// The position within the pixel that the n-th of several pictures samples, from -1/2 to 1/2 of a
/// pixel to the right and up. The first is the pixel's centre.
glm::dvec2 subpixelOffset(std::uint64_t n);

/// The same view, sampled at that offset.
Frustum sampledAt(Frustum frustum, const glm::dvec2& offset, int width, int height);

} // namespace edgeshade
