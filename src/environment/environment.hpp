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

} // namespace edgeshade
