#include "src/render/drawing/cap_alpha_test.hpp"

#include <GLES2/gl2.h>

namespace edgeshade {
namespace {

constexpr float aboveAnyAlpha = 2.0f;

} // namespace

void setCapAlphaTest(const gl::Program& program, const GpuScene& scene, std::size_t batch,
                     std::size_t material) {
    const AlphaLookup alpha = scene.alphaOf(batch, material);
    // BLEND surfaces are not in the depth buffer, so all of such a surface counts as cut out.
    const bool blend = scene.materials[material].alphaMode == AlphaMode::blend;
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, alpha.texture);
    program.setSampler("u_texture", 0);
    program.set("u_alphaChannel", alpha.channel);
    program.set("u_texcoordTransform", alpha.texcoordTransform);
    program.set("u_alphaScale", alpha.factor);
    program.set("u_alphaCutoff", blend ? aboveAnyAlpha : alpha.cutoff);
}

} // namespace edgeshade
