#include "src/environment/radiance_encoding.hpp"

#include "shaders_es2/environment_layout.glsl"

#include <algorithm>
#include <cmath>

namespace edgeshade {
namespace {

constexpr auto largestRoot = static_cast<float>(ENVIRONMENT_LARGEST_ROOT);

/// The least multiplier, of 255. Between neighbours of n and n + 1, filtering multiplier and colour
/// apart is wrong by 1 / (4 n (n + 1)), so small ones are not taken.
constexpr float leastMultiplier = 16.0f;

std::uint8_t byteOf(float value) {
    return static_cast<std::uint8_t>(std::lround(value));
}

} // namespace

float largestEncodedRadiance() {
    return largestRoot * largestRoot;
}

std::array<std::uint8_t, 4> encodeRadiance(const glm::vec3& radiance) {
    const glm::vec3 root =
        glm::sqrt(glm::clamp(radiance, 0.0f, largestEncodedRadiance())) / largestRoot;
    const float brightest = std::max({root.r, root.g, root.b});
    const float multiplier = std::max(leastMultiplier, std::ceil(255.0f * brightest));
    const glm::vec3 color = root * (255.0f * 255.0f / multiplier);
    return {byteOf(color.r), byteOf(color.g), byteOf(color.b), byteOf(multiplier)};
}

glm::vec3 decodeRadiance(const glm::vec4& stored) {
    const glm::vec3 root = glm::vec3(stored) * (stored.a * largestRoot);
    return root * root;
}

} // namespace edgeshade
