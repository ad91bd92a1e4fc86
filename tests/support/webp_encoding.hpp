#pragma once

#include "preprocess/base/file_io.hpp"

#include <span>

namespace edgeshade::test {

/// A WebP of 8-bit RGBA pixels, rows top to bottom: lossless, including the colours of clear
/// pixels, or approximate with `lossy`.
Bytes webpOf(std::span<const std::uint8_t> rgba, int width, int height, bool lossy = false);

/// smallPng()'s pixels as lossless WebP.
Bytes smallWebp();

/// An animation of one frame with these pixels.
Bytes animatedWebp();

} // namespace edgeshade::test
