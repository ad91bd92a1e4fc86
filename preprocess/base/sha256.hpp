#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace edgeshade {

/// The SHA-256 of the bytes (FIPS 180-4) as 64 hexadecimal digits.
std::string sha256(std::span<const std::uint8_t> bytes);

} // namespace edgeshade
