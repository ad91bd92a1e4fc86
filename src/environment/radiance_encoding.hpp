#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

namespace edgeshade {

/// The largest radiance that a texel holds; more is cut off.
float largestEncodedRadiance();

/// Linear radiance, 0 or more, as 8-bit RGBA: its square root over that of the largest, with a
/// common multiplier in alpha. A channel that is half of the largest one or more is off by 1 % at
/// most, where it is 1/4 or more; by 0.004 where it is less. Filtered linearly, grey stays grey.
std::array<std::uint8_t, 4> encodeRadiance(const glm::vec3& radiance);

/// Of a texel, or of texels filtered linearly, as the GL gives them: 0 to 1.
glm::vec3 decodeRadiance(const glm::vec4& stored);

} // namespace edgeshade
