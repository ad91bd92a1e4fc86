#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace edgeshade {

/// The media type of an encoded image by its first bytes: image/png, image/jpeg, image/webp or
/// image/ktx2; empty for any other.
std::string_view imageTypeOf(std::span<const std::uint8_t> bytes);

} // namespace edgeshade
