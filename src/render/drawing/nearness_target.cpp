#include "src/render/drawing/nearness_target.hpp"

#include "preprocess/base/error.hpp"

#include <GLES2/gl2.h>

namespace edgeshade {

void NearnessTarget::fit(int width, int height) {
    if (width == width_ && height == height_) return;
    width_ = height_ = 0; // should anything be refused
    target_ = gl::ColorTarget(width, height);
    depth_.emplace(width, height, capabilities_);
    depth_->attach();
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw Error(ExitStatus::unavailable, "This GL can't draw into a texture with depth and "
                                             "stencil, which a picture of nearness needs.");
    width_ = width;
    height_ = height;
}

void NearnessTarget::bind(int width, int height) {
    fit(width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, target_.framebuffer.name());
}

std::size_t NearnessTarget::bytes() const {
    const auto pixels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    return 4 * pixels + (depth_ ? depth_->bytes() : 0);
}

} // namespace edgeshade
