#pragma once

#include "preprocess/base/limits.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace edgeshade {

/// 8-bit RGBA, rows top to bottom.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;
};

/// "640x480 pixels".
std::string sizeText(int width, int height);

/// Counts the memory of decoding this many pixels. Throws LimitError.
void countPixels(int width, int height, const std::string& name, MemoryBudget& memory);

} // namespace edgeshade
