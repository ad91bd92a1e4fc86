#include "src/gl/framebuffer_keeper.hpp"

#include <GLES2/gl2.h>

namespace edgeshade::gl {

FramebufferKeeper::FramebufferKeeper() : scissor_(glIsEnabled(GL_SCISSOR_TEST) == GL_TRUE) {
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &name_);
    glDisable(GL_SCISSOR_TEST);
}

FramebufferKeeper::~FramebufferKeeper() {
    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(name_));
    if (scissor_) glEnable(GL_SCISSOR_TEST);
}

} // namespace edgeshade::gl
