#pragma once

#include "src/gl/program.hpp"
#include "src/scene/gpu_scene.hpp"

namespace edgeshade {

/// Sets an alpha lookup's uniforms, as far as the program, which is in use, has them, and the
/// texture of unit 0.
void setAlphaLookup(const gl::Program& program, const AlphaLookup& alpha);

/// Sets the alpha test that separates cutouts from solid parts of a batch's casters of one
/// material: the uniforms of caps.frag's ALPHA_TEST variant, which must be in use, and the texture
/// of unit 0.
void setCapAlphaTest(const gl::Program& program, const GpuScene& scene, std::size_t batch,
                     std::size_t material);

} // namespace edgeshade
