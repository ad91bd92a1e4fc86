#include "src/gl/depth_stencil.hpp"

#include "src/gl/platform.hpp"

#include <GLES2/gl2.h>
#include <GLES2/gl2ext.h>

namespace edgeshade::gl {
namespace {

#ifdef __EMSCRIPTEN__
// WebGL 1 has its own names for it (WebGL 1.0.3, section 6.8).
constexpr GLenum packedFormat = 0x84F9;     // DEPTH_STENCIL
constexpr GLenum packedAttachment = 0x821A; // DEPTH_STENCIL_ATTACHMENT
#else
constexpr GLenum packedFormat = GL_DEPTH24_STENCIL8_OES;
constexpr GLenum packedAttachment = 0;
#endif

Renderbuffer makeRenderbuffer(GLenum format, int width, int height) {
    Name name = 0;
    glGenRenderbuffers(1, &name);
    Renderbuffer made(name);
    glBindRenderbuffer(GL_RENDERBUFFER, name);
    glRenderbufferStorage(GL_RENDERBUFFER, format, width, height);
    glBindRenderbuffer(GL_RENDERBUFFER, 0);
    requireNoError("making a depth and stencil buffer");
    return made;
}

} // namespace

DepthStencil::DepthStencil(int width, int height, const Capabilities& capabilities) {
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    const bool packed = inBrowser || capabilities.has("GL_OES_packed_depth_stencil") ||
                        capabilities.version.starts_with("OpenGL ES 3");
    if (packed) {
        depth_ = makeRenderbuffer(packedFormat, width, height);
        bytes_ = 4 * pixels;
        return;
    }
    const bool deep = capabilities.has("GL_OES_depth24");
    depth_ =
        makeRenderbuffer(deep ? GL_DEPTH_COMPONENT24_OES : GL_DEPTH_COMPONENT16, width, height);
    stencil_ = makeRenderbuffer(GL_STENCIL_INDEX8, width, height);
    bytes_ = (deep ? 5 : 3) * pixels;
}

void DepthStencil::attach() const {
    const auto attachTo = [](GLenum attachment, const Renderbuffer& buffer) {
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer.name());
    };
    if (inBrowser) {
        attachTo(packedAttachment, depth_);
        return;
    }
    attachTo(GL_DEPTH_ATTACHMENT, depth_);
    attachTo(GL_STENCIL_ATTACHMENT, stencil_.name() != 0 ? stencil_ : depth_);
}

} // namespace edgeshade::gl
