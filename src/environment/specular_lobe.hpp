#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace edgeshade {

/// Directions that a GGX surface of one roughness reflects towards an eye above it, as the split
/// sum has them (normal, eye and reflected direction are one): Karis, "Real Shading in Unreal
/// Engine 4", 2013. The same every time.
class SpecularLobe {
  public:
    struct Sample {
        glm::vec3 direction; ///< +Z is the normal
        float weight;        ///< of all together 1
        float solidAngle;    ///< in sr, of what the sample stands for
    };

    /// Perceptual roughness above 0, to 1.
    SpecularLobe(float roughness, int samples);

    const std::vector<Sample>& samples() const { return samples_; }

    /// What `radiance`, called with a direction and a solid angle, gives around a direction of unit
    /// length.
    template <class Radiance>
    glm::vec3 filter(const glm::vec3& around, Radiance radiance) const {
        const glm::mat3 worldFromLobe = frameAround(around);
        glm::vec3 sum(0.0f);
        for (const Sample& sample : samples_)
            sum += sample.weight * radiance(worldFromLobe * sample.direction, sample.solidAngle);
        return sum;
    }

  private:
    static glm::mat3 frameAround(const glm::vec3& normal);

    std::vector<Sample> samples_;
};

/// The density of microfacets' normals, GGX, at a cosine to the normal. Perceptual roughness.
float ggxDistribution(float cosine, float roughness);

} // namespace edgeshade
