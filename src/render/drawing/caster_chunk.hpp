#pragma once

#include "src/gl/program.hpp"
#include "src/scene/gpu_scene.hpp"

#include <string>
#include <vector>

namespace edgeshade {

/// Attributes of drawCasterChunk(), in order.
inline const std::vector<std::string> casterAttributes = {"a_position", "a_texcoord", "a_color"};

/// Draws the casters of a chunk with the program in use, which must be an ALPHA_TEST variant if the
/// chunk's material is MASK. Returns vertex runs.
std::size_t drawCasterChunk(const GpuScene& scene, const SurfaceChunk& chunk,
                            const gl::Program& program);

} // namespace edgeshade
