#include "src/gl/draw_buffers.hpp"

#include "src/gl/entry_points.hpp"

#include <array>
#include <GLES2/gl2.h>
#include <GLES2/gl2ext.h>

namespace edgeshade::gl {

std::optional<DrawBuffers> DrawBuffers::find(const std::string& extensions,
                                             void* (*lookUp)(const char*)) {
    if (!listsExtension(extensions, "GL_EXT_draw_buffers")) return std::nullopt;
    GLint drawn = 0, attached = 0;
    glGetIntegerv(GL_MAX_DRAW_BUFFERS_EXT, &drawn);
    glGetIntegerv(GL_MAX_COLOR_ATTACHMENTS_EXT, &attached);
    DrawBuffers found;
    if (drawn < 2 || attached < 2 || !takeEntryPoint(found.draw_, lookUp, "glDrawBuffersEXT"))
        return std::nullopt;
    return found;
}

void DrawBuffers::attachSecond(unsigned texture) const {
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1_EXT, GL_TEXTURE_2D, texture, 0);
    constexpr std::array<GLenum, 2> both = {GL_COLOR_ATTACHMENT0_EXT, GL_COLOR_ATTACHMENT1_EXT};
    draw_(static_cast<GLsizei>(both.size()), both.data());
}

} // namespace edgeshade::gl
