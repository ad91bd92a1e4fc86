#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace edgeshade {

/// The number of codes of a JPEG's first Huffman table with more than the 256 possible (ITU-T T.81,
/// B.2.4.2); null if there is none, as in bytes that are no JPEG. stb_image before 2.28 writes such
/// codes past their array. Safe on untrusted input.
std::optional<int> oversizedHuffmanTable(std::span<const std::uint8_t> bytes);

} // namespace edgeshade
