#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

namespace edgeshade {

/// Radiance above this is clamped.
inline constexpr float largestEncodedRadiance = 64.0f;

/// Encodes linear radiance, 0 or more, as 8-bit RGBA: its square root over `largestRoot`, above 0,
/// with a common multiplier in alpha. A channel of at least half the brightest one is off by 1 % or
/// by a thousandth of largestRoot * sqrt(radiance), whichever is more.
std::array<std::uint8_t, 4> encodeRadiance(const glm::vec3& radiance, float largestRoot);

/// Decodes a texel, or texels filtered linearly by the GL, with values 0 to 1. Grey stays grey.
glm::vec3 decodeRadiance(const glm::vec4& stored, float largestRoot);

} // namespace edgeshade
