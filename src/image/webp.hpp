#pragma once

#include "preprocess/base/limits.hpp"
#include "src/image/image.hpp"

#include <span>
#include <string>

namespace edgeshade {

/// Refuses animations, which have no single picture to draw. `name` is for messages. Throws
/// InputError.
void requireStillWebp(std::span<const std::uint8_t> bytes, const std::string& name);

/// Decodes WebP like decodeImage(), with straight alpha. A program built without libwebp refuses
/// every image. Safe on untrusted input. Throws InputError.
Image decodeWebp(std::span<const std::uint8_t> bytes, const std::string& name,
                 MemoryBudget& memory);

} // namespace edgeshade
