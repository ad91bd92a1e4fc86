#pragma once

#include "src/environment/environment.hpp"

namespace edgeshade::test {

// shaders_es2/environment.glsl on the processor.

/// Decodes a texel, or texels filtered linearly by the GL, with values 0 to 1. Grey stays grey.
glm::vec3 decodeRadiance(const glm::vec4& stored, float largestRoot);

/// Irradiance / pi at a normal of unit length: the light that a white Lambert surface reflects.
glm::vec3 environmentDiffuse(const Environment& environment, const glm::vec3& normal);

/// Radiance around a reflected direction of unit length, filtered by the GGX lobe of a perceptual
/// roughness 0 to 1: the first factor of the split sum.
glm::vec3 environmentSpecular(const Environment& environment, const glm::vec3& direction,
                              float roughness);

} // namespace edgeshade::test
