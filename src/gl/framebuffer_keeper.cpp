#include "src/gl/framebuffer_keeper.hpp"

#include "src/gl/platform.hpp"

#include <GLES2/gl2.h>

namespace edgeshade::gl {

// Depth is never coarsened in browsers.
constexpr bool keepsDepthRange = !inBrowser;

FramebufferKeeper::FramebufferKeeper() : scissor_(glIsEnabled(GL_SCISSOR_TEST) == GL_TRUE) {
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &name_);
    if (scissor_) glGetIntegerv(GL_SCISSOR_BOX, scissorBox_);
    glDisable(GL_SCISSOR_TEST);
    if (!keepsDepthRange) return;
    glGetFloatv(GL_DEPTH_RANGE, depthRange_);
    glGetFloatv(GL_DEPTH_CLEAR_VALUE, &depthClear_);
    glDepthRangef(0.0f, 1.0f);
    glClearDepthf(1.0f);
}

FramebufferKeeper::~FramebufferKeeper() {
    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(name_));
    if (scissor_) {
        glEnable(GL_SCISSOR_TEST);
        glScissor(scissorBox_[0], scissorBox_[1], scissorBox_[2], scissorBox_[3]);
    }
    if (!keepsDepthRange) return;
    glDepthRangef(depthRange_[0], depthRange_[1]);
    glClearDepthf(depthClear_);
}

} // namespace edgeshade::gl
