#pragma once

#include "preprocess/gltf_document.hpp"

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

/// Decodes PNG, JPEG or WebP of at most 16384 x 16384, and of no more pixels than its bytes can
/// hold or `memory` has bytes for. Safe on untrusted input. `name` is for messages. Throws
/// InputError, LimitError for what `memory` can't take.
Image decodeImage(std::span<const std::uint8_t> bytes, const std::string& name,
                  MemoryBudget& memory);

/// The same of one image by itself, within the usual limits.
Image decodeImage(std::span<const std::uint8_t> bytes, const std::string& name);

/// The same of an image of the document, wherever it lies.
Image decodeImage(const GltfDocument& document, int image, MemoryBudget& memory);

/// Counts what decoding so many pixels takes. Throws LimitError.
void countPixels(int width, int height, const std::string& name, MemoryBudget& memory);

/// The image scaled up to powers of two, for devices whose textures need that, or down to the
/// largest one of at most `largest`, which is 1 or more.
Image toPowersOfTwo(const Image& image, int largest);

} // namespace edgeshade
