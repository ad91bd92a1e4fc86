#include "src/render/frame/pass_state.hpp"

namespace edgeshade {
namespace {

void enable(GLenum what, bool on) {
    if (on)
        glEnable(what);
    else
        glDisable(what);
}

} // namespace

void set(const PassState::Blend& blend) {
    glBlendFuncSeparate(blend.source, blend.target, blend.alphaSource, blend.alphaTarget);
}

void set(const PassState& state) {
    glColorMask(state.color[0], state.color[1], state.color[2], state.color[3]);
    glDepthMask(state.depthWrites);
    enable(GL_DEPTH_TEST, state.depth.has_value());
    if (state.depth) glDepthFunc(*state.depth);
    enable(GL_BLEND, state.blend.has_value());
    if (state.blend) set(*state.blend);
    enable(GL_STENCIL_TEST, state.stencil.has_value());
    if (!state.stencil) return;
    glStencilMask(0xFF);
    glStencilFunc(state.stencil->function, 0, 0xFF);
    glStencilOp(GL_KEEP, GL_KEEP, state.stencil->then);
}

} // namespace edgeshade
