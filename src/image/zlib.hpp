#pragma once

#include "preprocess/base/file_io.hpp"

#include <optional>
#include <span>

namespace edgeshade {

/// A zlib stream (RFC 1950) of the bytes, 1 to 2^30 of them. Same bytes in, same bytes out.
/// Throws Error(unavailable) for more.
Bytes deflated(std::span<const std::uint8_t> bytes);

/// What was in it; nothing where it is broken or holds other than `size` bytes. Safe on untrusted
/// input; takes no more memory than `size`, at most 2^30.
std::optional<Bytes> inflated(std::span<const std::uint8_t> stream, std::size_t size);

} // namespace edgeshade
