#pragma once

#include "preprocess/base/file_io.hpp"

#include <span>

namespace edgeshade {

/// A PNG of 16-bit grey and alpha, two numbers per pixel, rows top to bottom. The same pixels give
/// the same bytes. Throws Error(unavailable) for more than 2^28 pixels.
Bytes encodeGreyAlphaPng(std::span<const std::uint16_t> greyAlpha, int width, int height);

} // namespace edgeshade
