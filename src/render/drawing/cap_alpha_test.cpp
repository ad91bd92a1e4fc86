#include "src/render/drawing/cap_alpha_test.hpp"

namespace edgeshade {
namespace {

constexpr float aboveAnyAlpha = 2.0f;

} // namespace

void setAlphaLookup(const gl::Program& program, const AlphaLookup& alpha) {
    program.setTexture("u_texture", 0, alpha.texture);
    program.set("u_alphaChannel", alpha.channel);
    program.set("u_texcoordTransform", alpha.texcoordTransform);
    program.set("u_alphaScale", alpha.factor);
    program.set("u_alphaCutoff", alpha.cutoff);
}

void setCapAlphaTest(const gl::Program& program, const GpuScene& scene, std::size_t batch,
                     std::size_t material) {
    AlphaLookup alpha = scene.alphaOf(batch, material);
    // BLEND surfaces are not in the depth buffer, so all of such a surface counts as cut out, and
    // so does what a section cuts away.
    const Material& of = scene.materials[material];
    if (of.alphaMode == AlphaMode::blend || !of.isSeen()) alpha.cutoff = aboveAnyAlpha;
    setAlphaLookup(program, alpha);
}

} // namespace edgeshade
