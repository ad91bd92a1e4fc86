#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace edgeshade {

/// The number of codes of the first Huffman table of a JPEG that has more than the 256 that there
/// can be (ITU-T T.81, B.2.4.2); null if none has. stb_image before 2.28 writes them past their
/// array. Bytes that are no JPEG have no such table. Safe on untrusted input.
std::optional<int> oversizedHuffmanTable(std::span<const std::uint8_t> bytes);

} // namespace edgeshade
