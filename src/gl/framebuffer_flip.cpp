#include "src/gl/framebuffer_flip.hpp"

#include "src/gl/entry_points.hpp"

#include <GLES2/gl2.h>

namespace edgeshade::gl {

std::optional<FramebufferFlip> FramebufferFlip::find(const std::string& extensions,
                                                     void* (*lookUp)(const char*)) {
    FramebufferFlip found;
    if (!listsExtension(extensions, "GL_MESA_framebuffer_flip_y") ||
        !takeEntryPoint(found.set_, lookUp, "glFramebufferParameteriMESA"))
        return std::nullopt;
    return found;
}

void FramebufferFlip::flip() const {
    constexpr GLenum flipped = 0x8BBB; // FRAMEBUFFER_FLIP_Y_MESA
    set_(GL_FRAMEBUFFER, flipped, GL_TRUE);
}

} // namespace edgeshade::gl
