#pragma once

#include <glm/gtc/color_space.hpp>

namespace edgeshade {

/// Encodes a linear colour as sRGB (IEC 61966-2-1); alpha stays.
inline glm::vec4 srgbFromLinear(const glm::vec4& linear) {
    return {glm::convertLinearToSRGB(glm::clamp(glm::vec3(linear), 0.0f, 1.0f)), linear.a};
}

/// Decodes an sRGB colour, 0..1, to linear.
inline glm::vec3 linearFromSrgb(const glm::vec3& srgb) {
    return glm::convertSRGBToLinear(srgb);
}

} // namespace edgeshade
