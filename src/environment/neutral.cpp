#include "src/environment/neutral.hpp"

#include "src/environment/specular_lobe.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace edgeshade {
namespace {

/// Values at even steps of the height from -1 to 1, interpolated linearly.
class HeightTable {
  public:
    template <class Value>
    explicit HeightTable(Value value) {
        for (int i = 0; i < count; ++i)
            values_[static_cast<std::size_t>(i)] =
                value(static_cast<float>(2 * i) / static_cast<float>(last) - 1.0f);
    }

    float operator()(float height) const {
        const float step =
            std::clamp((height + 1.0f) * (0.5f * last), 0.0f, static_cast<float>(last));
        const auto first = static_cast<std::size_t>(std::min(static_cast<int>(step), last - 1));
        return std::lerp(values_[first], values_[first + 1], step - static_cast<float>(first));
    }

  private:
    static constexpr int count = 257, last = count - 1;
    std::array<float, count> values_{};
};

/// Filtered radiance around directions by their height; nothing depends on the azimuth.
HeightTable filteredByHeight(const HeightTable& radiance, float roughness) {
    constexpr int samples = 128;
    const SpecularLobe lobe(roughness, samples);
    return HeightTable([&](float height) {
        const glm::vec3 around(std::sqrt(1.0f - height * height), height, 0.0f);
        return lobe
            .filter(around, [&](const glm::vec3& d, float) { return glm::vec3(radiance(d.y)); })
            .r;
    });
}

DiffuseCoefficients diffuseOf(const HeightTable& radiance) {
    constexpr int size = 64;
    const OctahedralMap grid(size);
    DiffuseSum sum;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const glm::vec3 direction = grid.direction(x, y);
            const auto solidAngle = static_cast<double>(grid.solidAngle(x, y));
            sum.add(direction, glm::vec3(radiance(direction.y)), solidAngle);
        }
    return sum.coefficients();
}

} // namespace

float neutralRadiance(float height) {
    constexpr float mean = 1.0241916f; // mean of the sum below
    const float ground = 0.55f + 0.15f * height;
    const float sky = 0.9f;
    const float band = height / 0.18f;
    const float radiance = glm::mix(ground, sky, glm::smoothstep(-0.06f, 0.06f, height)) +
                           0.7f * std::exp(-band * band) +
                           1.8f * glm::smoothstep(0.5f, 1.0f, height);
    return radiance / mean;
}

Environment neutralEnvironment() {
    const HeightTable radiance(neutralRadiance);
    Environment environment;
    environment.diffuse = diffuseOf(radiance);
    environment.specular = Atlas(neutralRadiance(1.0f));
    for (int level = 0; level < Atlas::levels(); ++level) {
        const HeightTable filtered =
            level == 0 ? radiance : filteredByHeight(radiance, Atlas::roughness(level));
        OctahedralMap map(Atlas::mapSize(level));
        map.fill([&](const glm::vec3& direction) { return glm::vec3(filtered(direction.y)); });
        environment.specular.setLevel(level, map);
    }
    return environment;
}

} // namespace edgeshade
