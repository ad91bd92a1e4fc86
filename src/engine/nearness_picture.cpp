#include "src/engine/nearness_picture.hpp"

#include "preprocess/base/error.hpp"

#include <GLES2/gl2.h>

namespace edgeshade {

void NearnessPicture::fit(int width, int height) {
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

void NearnessPicture::draw(Renderer& renderer, const GpuScene& scene, const FrameView& view,
                           const Frustum& asked) {
    fit(view.width, view.height);
    glBindFramebuffer(GL_FRAMEBUFFER, target_.framebuffer.name());
    renderer.drawNearness(scene, view);
    told_.texture = target_.texture.name();
    told_.scale = view.near();
    told_.offset = 0.0;
    if (!view.frustum.orthographic) return;
    const double back = asked.viewFromWorld[3].z - view.frustum.viewFromWorld[3].z;
    told_.scale = -1.0 / (view.farPlane - view.near());
    told_.offset = (back - view.farPlane) * told_.scale;
}

std::size_t NearnessPicture::bytes() const {
    const auto pixels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    return 4 * pixels + (depth_ ? depth_->bytes() : 0);
}

} // namespace edgeshade
