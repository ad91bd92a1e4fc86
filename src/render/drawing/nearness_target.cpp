#include "src/render/drawing/nearness_target.hpp"

#include "preprocess/base/error.hpp"

#include <GLES2/gl2.h>

namespace edgeshade {

void NearnessTarget::fit(int width, int height) {
    if (width == width_ && height == height_) return;
    width_ = height_ = 0; // in case the GL refuses below
    target_ = gl::ColorTarget(width, height);
    depth_.emplace(width, height, capabilities_);
    depth_->attach();
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        attachDepthAlone(width, height);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw Error(ExitStatus::unavailable, "This GL can't draw into a texture with depth, "
                                             "which a picture of nearness needs.");
    width_ = width;
    height_ = height;
}

/// Attaches depth only, for GLs that have no renderbuffer with both depth and stencil.
void NearnessTarget::attachDepthAlone(int width, int height) {
    depth_.reset();
    gl::Name name = 0;
    glGenRenderbuffers(1, &name);
    depthAlone_ = gl::Renderbuffer(name);
    glBindRenderbuffer(GL_RENDERBUFFER, name);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT16, width, height);
    glBindRenderbuffer(GL_RENDERBUFFER, 0);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, name);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_STENCIL_ATTACHMENT, GL_RENDERBUFFER, 0);
}

void NearnessTarget::bind(int width, int height, const gl::DepthStencil* shared) {
    fit(width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, target_.framebuffer.name());
    if (shared)
        shared->attach();
    else if (depth_)
        depth_->attach();
}

std::size_t NearnessTarget::bytes() const {
    const auto pixels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    return 4 * pixels + (depth_ ? depth_->bytes() : 2 * pixels);
}

} // namespace edgeshade
