#pragma once

#include "src/gl/program.hpp"
#include "src/scene/gpu_scene.hpp"

#include <string>
#include <vector>

namespace edgeshade {

/// Attributes of drawCasterChunk(), in order.
inline const std::vector<std::string> casterAttributes = {"a_position", "a_texcoord", "a_color"};

/// Sets the alpha test for a MASK caster's cutouts: the uniforms of an ALPHA_TEST variant that is
/// in use, as in shadow_map.frag, and the texture of unit 0.
void setCasterCutout(const GpuScene& scene, const Material& material, const gl::Program& program);

/// Draws the casters of a chunk with the program in use, which must be an ALPHA_TEST variant if the
/// chunk's material is MASK. Returns vertex runs.
std::size_t drawCasterChunk(const GpuScene& scene, const SurfaceChunk& chunk,
                            const gl::Program& program);

} // namespace edgeshade
