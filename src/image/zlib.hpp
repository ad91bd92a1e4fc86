#pragma once

#include "preprocess/base/file_io.hpp"

#include <optional>
#include <span>

namespace edgeshade {

/// Compresses 1 to 2^30 bytes to a zlib stream (RFC 1950). The same bytes give the same stream.
/// Throws Error(unavailable) for more.
Bytes deflated(std::span<const std::uint8_t> bytes);

/// Decompresses a stream; null if it is broken or doesn't hold exactly `size` bytes. Safe on
/// untrusted input; allocates no more than `size`, at most 2^30.
std::optional<Bytes> inflated(std::span<const std::uint8_t> stream, std::size_t size);

} // namespace edgeshade
