#pragma once

#include "src/gl/capabilities.hpp"
#include "src/shadow/geometry/pixel_rectangle.hpp"

#include <cstdint>
#include <vector>

namespace edgeshade::gl {

/// Whether depth buffers of one sample a pixel can be read (GL_NV_read_depth).
bool canReadDepth(const Capabilities& capabilities);

/// Reads a rectangle of the current framebuffer's: `depths` has its pixels then, rows from below, 0
/// to 2^32 - 1 for depths from the near to the far end of the depth range. Returns how many bits
/// that range has; 0 where it can't be read, as it has several samples a pixel or no depth.
int readDepth(const PixelRectangle& of, std::vector<std::uint32_t>& depths);

} // namespace edgeshade::gl
