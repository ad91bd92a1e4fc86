#pragma once

#include "src/image/decode.hpp"

namespace edgeshade {

/// Refuses animations, of which no picture is the one to draw. `name` is for messages. Throws
/// InputError.
void requireStillWebp(std::span<const std::uint8_t> bytes, const std::string& name);

/// Decodes WebP, alpha not multiplied in, as decodeImage() does. Where the program was built
/// without libwebp, every picture is refused. Safe on untrusted input. Throws InputError.
Image decodeWebp(std::span<const std::uint8_t> bytes, const std::string& name,
                 MemoryBudget& memory);

} // namespace edgeshade
