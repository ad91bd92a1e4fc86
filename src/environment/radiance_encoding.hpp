#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

namespace edgeshade {

/// Radiance above this is cut off.
inline constexpr float largestEncodedRadiance = 64.0f;

/// Linear radiance, 0 or more, as 8-bit RGBA: its square root over `largestRoot`, above 0, with a
/// common multiplier in alpha. A channel that is half of the brightest one or more is off by 1 % or
/// by a thousandth of largestRoot * sqrt(radiance), whichever is more.
std::array<std::uint8_t, 4> encodeRadiance(const glm::vec3& radiance, float largestRoot);

/// Of a texel, or of texels filtered linearly, as the GL gives them: 0 to 1. Grey stays grey.
glm::vec3 decodeRadiance(const glm::vec4& stored, float largestRoot);

} // namespace edgeshade
