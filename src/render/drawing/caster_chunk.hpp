#pragma once

#include "src/gl/program.hpp"
#include "src/scene/gpu_scene.hpp"

#include <string>
#include <vector>

namespace edgeshade {

/// Attributes of drawCasterChunk(), in order.
inline const std::vector<std::string> casterAttributes = {"a_position", "a_texcoord", "a_color"};

/// Sets what tells a MASK caster's cutouts: uniforms of an ALPHA_TEST variant that is in use, as
/// shadow_map.frag has them, and the texture of unit 0.
void setCasterCutout(const GpuScene& scene, const Material& material, const gl::Program& program);

/// Draws what of a chunk casts: where its material is MASK the program, which is in use, must be
/// an ALPHA_TEST variant. Returns vertex runs.
std::size_t drawCasterChunk(const GpuScene& scene, const SurfaceChunk& chunk,
                            const gl::Program& program);

} // namespace edgeshade
