#include "src/viewer/smoothing.hpp"

#include "src/viewer/counting_pace.hpp"

#include <GLES2/gl2.h>

namespace edgeshade::viewer {

void Smoothing::see(std::size_t picture, std::size_t of, const glm::ivec2& size) {
    if (picture == picture_ && of == of_ && size == size_) return;
    picture_ = picture;
    of_ = of;
    size_ = size;
    done_ = shown_ = 0;
    if (of > 0) return;
    sum_ = {};
    drawn_ = {};
    depthStencil_.reset();
}

void Smoothing::begin() {
    const gl::Name caller = gl::boundFramebuffer();
    if (done_ == 0 && sum_.size() != size_) {
        drawn_ = gl::ColorTarget(size_.x, size_.y);
        depthStencil_.emplace(size_.x, size_.y, capabilities_);
        depthStencil_->attach();
        if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
            depthStencil_.reset();
    }
    if (done_ == 0) sum_.begin(size_.x, size_.y);
    glBindFramebuffer(GL_FRAMEBUFFER, depthStencil_ ? drawn_.framebuffer.name() : caller);
}

bool Smoothing::end() {
    if (!depthStencil_) {
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, drawn_.texture.name());
        glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, size_.x, size_.y);
    }
    sum_.add(drawn_.texture.name());
    const std::size_t picture = nextPicture(done_++, of_);
    if (done_ < picture) return false;
    shown_ = done_;
    return true;
}

void Smoothing::show() const {
    sum_.show(gl::boundFramebuffer(), static_cast<std::uint32_t>(255 * shown_));
}

std::size_t Smoothing::bytes() const {
    const auto pixels = static_cast<std::size_t>(sum_.size().x) * sum_.size().y;
    return sum_.bytes() + (depthStencil_ ? 4 * pixels + depthStencil_->bytes() : 0);
}

} // namespace edgeshade::viewer
