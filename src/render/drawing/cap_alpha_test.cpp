#include "src/render/drawing/cap_alpha_test.hpp"

#include <GLES2/gl2.h>

namespace edgeshade {
namespace {

constexpr float aboveAnyAlpha = 2.0f;

} // namespace

void setCapAlphaTest(const gl::Program& program, const Material& material,
                     const Textures& textures) {
    // Nothing of a BLEND surface is in the depth buffer, so all of it counts as cut out.
    const bool blend = material.alphaMode == AlphaMode::blend;
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, textures.of(material.baseColor()));
    program.setSampler("u_texture", 0);
    program.set("u_alphaScale", material.baseColorFactor.a);
    program.set("u_alphaCutoff", blend ? aboveAnyAlpha : material.alphaCutoff);
}

} // namespace edgeshade
