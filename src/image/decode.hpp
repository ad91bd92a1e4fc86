#pragma once

#include "preprocess/gltf/gltf_document.hpp"
#include "src/image/image.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace edgeshade {

/// Decodes PNG, JPEG or WebP of at most 16384 x 16384, and of no more pixels than its bytes can
/// hold or `memory` allows. Safe on untrusted input. `name` is for messages. Throws InputError, or
/// LimitError beyond `memory`.
Image decodeImage(std::span<const std::uint8_t> bytes, const std::string& name,
                  MemoryBudget& memory);

/// As above for a single image, within the default limits.
Image decodeImage(std::span<const std::uint8_t> bytes, const std::string& name);

/// As above for an image of the document, wherever it is stored.
Image decodeImage(const GltfDocument& document, int image, MemoryBudget& memory);

/// The image scaled to powers of two, for devices whose textures need that: up to the next one, but
/// no larger than the largest one of at most `largest`, which is 1 or more.
Image toPowersOfTwo(const Image& image, int largest);

} // namespace edgeshade
