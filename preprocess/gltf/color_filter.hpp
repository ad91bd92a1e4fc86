#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace edgeshade {

/// Undoes KHR_meshopt_compression's filter COLOR in place: from Y, Co, Cg and alpha, of as many
/// bits as alpha says, to red, green, blue and alpha of all bits. `stride`: bytes a colour, 4 or 8.
/// Bytes that no encoder writes become some colour.
void decodeColorFilter(std::span<std::uint8_t> colors, std::size_t stride);

} // namespace edgeshade
