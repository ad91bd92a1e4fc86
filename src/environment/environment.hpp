#pragma once

#include "src/environment/atlas.hpp"
#include "src/environment/diffuse_sum.hpp"

#include <glm/glm.hpp>

namespace edgeshade {

/// Distant light from all directions, without shadows, ready to be sampled: linear radiance in the
/// world's axes, +Y up. Made by neutralEnvironment() or readEnvironment(), uploaded as a
/// GpuEnvironment, and sampled on the GPU by shaders_es2/environment.glsl.
struct Environment {
    DiffuseCoefficients diffuse{};
    Atlas specular;
};

/// Irradiance / pi at a normal of unit length: the light that a white Lambert surface reflects.
/// environment.glsl computes this and the next function in the same way.
glm::vec3 environmentDiffuse(const Environment& environment, const glm::vec3& normal);

/// Radiance around a reflected direction of unit length, filtered by the GGX lobe of a perceptual
/// roughness 0 to 1: the first factor of the split sum.
glm::vec3 environmentSpecular(const Environment& environment, const glm::vec3& direction,
                              float roughness);

} // namespace edgeshade
