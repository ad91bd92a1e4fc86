#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace edgeshade {

/// Undoes KHR_meshopt_compression's filter COLOR in place: converts Y, Co, Cg and alpha, of the
/// number of bits that alpha gives, to red, green, blue and alpha at full range. `stride`: bytes
/// per colour, 4 or 8. Invalid bytes decode to an arbitrary colour.
void decodeColorFilter(std::span<std::uint8_t> colors, std::size_t stride);

} // namespace edgeshade
