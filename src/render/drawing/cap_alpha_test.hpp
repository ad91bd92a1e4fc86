#pragma once

#include "src/gl/program.hpp"
#include "src/scene/gpu_scene.hpp"

namespace edgeshade {

/// Sets what tells the cutouts of a batch's casters of a material from their solid parts: the
/// uniforms of caps.frag's ALPHA_TEST variant, which must be in use, and the texture of unit 0.
void setCapAlphaTest(const gl::Program& program, const GpuScene& scene, std::size_t batch,
                     std::size_t material);

} // namespace edgeshade
