#include "src/gl/color_target.hpp"

#include <GLES2/gl2.h>

namespace edgeshade::gl {

ColorTarget::ColorTarget(int width, int height) {
    glActiveTexture(GL_TEXTURE0);
    texture = nearestTexture();
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glBindTexture(GL_TEXTURE_2D, 0);
    requireNoError("making a picture to draw into");

    Name name = 0;
    glGenFramebuffers(1, &name);
    framebuffer = Framebuffer(name);
    glBindFramebuffer(GL_FRAMEBUFFER, name);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.name(), 0);
}

} // namespace edgeshade::gl
