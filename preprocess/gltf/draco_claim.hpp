#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace edgeshade {

/// What the head of a Draco mesh stream says of its size. The decoder takes memory by it before it
/// has seen whether the bytes hold that much.
struct DracoClaim {
    std::uint64_t faces = 0;
    std::uint64_t points = 0;         ///< vertices of the connectivity; splits count as such
    std::uint64_t attributeParts = 0; ///< with a connectivity of their own

    /// Bytes that decoding takes, roughly.
    std::uint64_t memoryBytes() const;
};

/// Reads the claim (Draco bitstream 2.2, "Decode Header" and "DecodeConnectivityData"); null where
/// there is none: the decoder then says what is wrong.
std::optional<DracoClaim> dracoClaim(std::span<const std::uint8_t> bytes);

} // namespace edgeshade
