#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace edgeshade {

/// Sizes that a Draco mesh stream's header claims. The decoder allocates memory for them before it
/// knows whether the bytes hold that much.
struct DracoClaim {
    std::uint64_t faces = 0;
    std::uint64_t points = 0;         ///< vertices of the connectivity, splits included
    std::uint64_t attributeParts = 0; ///< those with their own connectivity

    /// Bytes that decoding takes, approximately.
    std::uint64_t memoryBytes() const;
};

/// Reads the claim (Draco bitstream 2.2, "Decode Header" and "DecodeConnectivityData"). Null if
/// there is none: the decoder then reports the error.
std::optional<DracoClaim> dracoClaim(std::span<const std::uint8_t> bytes);

} // namespace edgeshade
