#pragma once

#include "preprocess/file_io.hpp"

#include <span>

namespace edgeshade::test {

/// A WebP of 8-bit RGBA pixels, rows top to bottom: every bit kept, colours of clear pixels too,
/// or, with `lossy`, about what they are.
Bytes webpOf(std::span<const std::uint8_t> rgba, int width, int height, bool lossy = false);

/// smallPng()'s pixels as WebP, every bit kept.
Bytes smallWebp();

/// An animation of one frame with these pixels.
Bytes animatedWebp();

} // namespace edgeshade::test
