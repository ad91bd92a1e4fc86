#pragma once

#include "preprocess/base/file_io.hpp"

#include <span>

namespace edgeshade {

/// A PNG of 8-bit RGBA pixels, rows top to bottom. The same pixels give the same bytes.
Bytes encodePng(std::span<const std::uint8_t> rgba, int width, int height);

} // namespace edgeshade
