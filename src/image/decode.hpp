#pragma once

#include "preprocess/limits.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace edgeshade {

/// 8-bit RGBA, rows top to bottom.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;
};

/// Decodes PNG or JPEG of at most 16384 x 16384, and of no more pixels than its bytes can hold or
/// `memory` has bytes for. Safe on untrusted input. `name` is for messages. Throws InputError.
Image decodeImage(std::span<const std::uint8_t> bytes, const std::string& name,
                  MemoryBudget& memory);

/// The same of one image by itself, within the usual limits.
Image decodeImage(std::span<const std::uint8_t> bytes, const std::string& name);

/// The image scaled up to powers of two, for devices whose textures need that, or down to the
/// largest one of at most `largest`, which is 1 or more.
Image toPowersOfTwo(const Image& image, int largest);

} // namespace edgeshade
