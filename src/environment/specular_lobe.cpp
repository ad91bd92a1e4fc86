#include "src/environment/specular_lobe.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>

namespace edgeshade {
namespace {

constexpr float floatPi = std::numbers::pi_v<float>;

/// The number's digits in base 2, mirrored behind the point.
float radicalInverse(std::uint32_t number) {
    float inverse = 0.0f;
    for (float digit = 0.5f; number != 0; number >>= 1, digit *= 0.5f)
        if (number & 1) inverse += digit;
    return inverse;
}

} // namespace

float ggxDistribution(float cosine, float roughness) {
    const float alpha = roughness * roughness;
    // 1 + cosine^2 (alpha^2 - 1), without cancellation where both are near 1.
    const float base = (1.0f - cosine) * (1.0f + cosine) + cosine * cosine * alpha * alpha;
    return alpha * alpha / (floatPi * base * base);
}

SpecularLobe::SpecularLobe(float roughness, int samples) {
    const float square = roughness * roughness * roughness * roughness; // alpha squared
    // Up to this share of the half vectors, light arrives from above the surface.
    const float above = 1.0f / (1.0f + square);
    float sum = 0.0f;
    for (int i = 0; i < samples; ++i) {
        const float share = above * (static_cast<float>(i) + 0.5f) / static_cast<float>(samples);
        const float angle = 2.0f * floatPi * radicalInverse(static_cast<std::uint32_t>(i));
        const float halfCosine = std::sqrt((1.0f - share) / (1.0f + (square - 1.0f) * share));
        const float halfSine = std::sqrt(share * square / (1.0f + (square - 1.0f) * share));
        const float cosine = 1.0f - 2.0f * halfSine * halfSine;
        const float sine = 2.0f * halfCosine * halfSine;
        const float density = ggxDistribution(halfCosine, roughness) / (4.0f * above);
        samples_.push_back({{sine * std::cos(angle), sine * std::sin(angle), cosine},
                            cosine,
                            1.0f / (static_cast<float>(samples) * density)});
        sum += cosine;
    }
    for (Sample& sample : samples_)
        sample.weight /= sum;
}

glm::mat3 SpecularLobe::frameAround(const glm::vec3& normal) {
    // Duff et al., "Building an Orthonormal Basis, Revisited", 2017.
    const float sign = std::copysign(1.0f, normal.z);
    const float a = -1.0f / (sign + normal.z);
    const float b = normal.x * normal.y * a;
    return {glm::vec3(1.0f + sign * normal.x * normal.x * a, sign * b, -sign * normal.x),
            glm::vec3(b, sign + normal.y * normal.y * a, -normal.y), normal};
}

} // namespace edgeshade
