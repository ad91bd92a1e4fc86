#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

namespace edgeshade {

/// Radiance above this is clamped.
inline constexpr float largestEncodedRadiance = 64.0f;

/// Encodes linear radiance, 0 or more, as 8-bit RGBA: its square root over `largestRoot`, above 0,
/// with a common multiplier in alpha. shaders_es2/environment.glsl decodes it. A channel of at
/// least half the brightest one is off by 1 % or by a thousandth of largestRoot * sqrt(radiance),
/// whichever is more.
std::array<std::uint8_t, 4> encodeRadiance(const glm::vec3& radiance, float largestRoot);

} // namespace edgeshade
