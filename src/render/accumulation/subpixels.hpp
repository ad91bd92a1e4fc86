#pragma once

#include "src/settings/settings.hpp"
#include "src/shadow/view/frustum.hpp"

#include <cstdint>

namespace edgeshade {

inline constexpr std::size_t mostSubpixels = settings::smooth.domain.high;

/// Where within its pixels the n-th of several pictures is sampled, from -1/2 to 1/2 of a pixel
/// across and up; the first in the middle.
glm::dvec2 subpixelOffset(std::uint64_t n);

/// The same picture, sampled there.
Frustum sampledAt(Frustum frustum, const glm::dvec2& offset, int width, int height);

} // namespace edgeshade
