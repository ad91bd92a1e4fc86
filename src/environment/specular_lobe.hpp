#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace edgeshade {

/// Directions that a GGX surface of one roughness reflects to an eye above it, under the split
/// sum's assumption that normal, eye and reflected direction coincide: Karis, "Real Shading in
/// Unreal Engine 4", 2013. Deterministic.
class SpecularLobe {
  public:
    struct Sample {
        glm::vec3 direction; ///< +Z is the normal
        float weight;        ///< all weights sum to 1
        float solidAngle;    ///< of the sample, in sr
    };

    /// Perceptual roughness above 0, up to 1.
    SpecularLobe(float roughness, int samples);

    const std::vector<Sample>& samples() const { return samples_; }

    /// The weighted mean of `radiance`, called with a direction and a solid angle, around a
    /// direction of unit length.
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

/// GGX density of microfacet normals at a cosine to the normal, for a perceptual roughness.
float ggxDistribution(float cosine, float roughness);

} // namespace edgeshade
