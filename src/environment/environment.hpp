#pragma once

#include "src/environment/atlas.hpp"
#include "src/environment/diffuse_sum.hpp"

#include <glm/glm.hpp>

namespace edgeshade {

/// Light from all around, without end and without shadow, ready to be looked up: linear radiance in
/// the world's axes, +Y up. neutralEnvironment() and readEnvironment() make one,
/// uploadEnvironment() brings it to the GPU, shaders_es2/environment.glsl looks it up there.
struct Environment {
    DiffuseCoefficients diffuse{};
    Atlas specular;
};

/// What a white Lambert surface of this normal, of unit length, sends back: irradiance / pi. The
/// same as in environment.glsl; so is the next.
glm::vec3 environmentDiffuse(const Environment& environment, const glm::vec3& normal);

/// Radiance around a reflected direction, of unit length, filtered by the GGX lobe of a perceptual
/// roughness 0 to 1: the first factor of the split sum.
glm::vec3 environmentSpecular(const Environment& environment, const glm::vec3& direction,
                              float roughness);

} // namespace edgeshade
