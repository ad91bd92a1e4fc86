#include "src/environment/radiance_encoding.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade {
namespace {

/// The smallest multiplier, of 255. Some GLs filter to 8 bits, with an error of up to one, which is
/// large relative to a small multiplier.
constexpr float leastMultiplier = 64.0f;

std::uint8_t byteOf(float value) {
    return static_cast<std::uint8_t>(std::lround(value));
}

} // namespace

std::array<std::uint8_t, 4> encodeRadiance(const glm::vec3& radiance, float largestRoot) {
    const glm::vec3 root =
        glm::sqrt(glm::clamp(radiance, 0.0f, largestRoot * largestRoot)) / largestRoot;
    const float brightest = std::max({root.r, root.g, root.b});
    const float multiplier = std::max(leastMultiplier, std::ceil(255.0f * brightest));
    const glm::vec3 color = root * (255.0f * 255.0f / multiplier);
    return {byteOf(color.r), byteOf(color.g), byteOf(color.b), byteOf(multiplier)};
}

} // namespace edgeshade
