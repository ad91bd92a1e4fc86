#include "src/render/frame/ambient_target.hpp"

#include "preprocess/base/error.hpp"
#include "shaders_es2.hpp"
#include "src/gl/framebuffer_keeper.hpp"

#include <GLES2/gl2.h>

namespace edgeshade {
namespace {

bool isDrawable() {
    return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

} // namespace

bool AmbientTarget::isWanted(const RenderSettings& settings, const gl::Capabilities& capabilities) {
    const bool possible = capabilities.drawBuffers && capabilities.samples <= 1;
    if (settings.ambientTarget == AmbientTargetChoice::on && !possible)
        throw Error(ExitStatus::unavailable,
                    "This GL can't draw two colours at once (GL_EXT_draw_buffers), or has several "
                    "samples a pixel; '--ambient-target off' does without.");
    return possible && (settings.ambientTarget == AmbientTargetChoice::on ||
                        (settings.ambientTarget == AmbientTargetChoice::automatic &&
                         capabilities.isSoftware() && capabilities.framebufferFlip));
}

bool AmbientTarget::pays(const GpuScene& scene, const FrameView& view) {
    constexpr double pixelsOfVertex = 10.0;
    double vertices = 0.0;
    for (const GpuBatch& batch : scene.batches)
        for (const SurfaceChunk& chunk : *batch.surfaces)
            if (!batch.hidden && scene.materials[chunk.material].alphaMode != AlphaMode::blend)
                vertices += chunk.indexCount;
    return pixelsOfVertex * vertices >= static_cast<double>(view.width) * view.height;
}

bool AmbientTarget::fit(int width, int height) {
    if (refused_) return false;
    GLint bound = 0;
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &bound);
    const bool flipped = bound == 0 && capabilities_.framebufferFlip;
    if (size_ == glm::ivec2(width, height) && flipped == flipped_) return true;
    const gl::FramebufferKeeper keeper;
    size_ = glm::ivec2(0); // should anything be refused
    flipped_ = flipped;
    refused_ = !make(width, height);
    if (!refused_) size_ = {width, height};
    return !refused_;
}

bool AmbientTarget::make(int width, int height) {
    depthStencil_.emplace(width, height, capabilities_);
    picture_ = gl::ColorTarget(width, height);
    depthStencil_->attach();
    flip();
    if (!isDrawable()) return false;
    gl::ColorTarget other(width, height);
    ambient_ = std::move(other.texture);
    both_ = std::move(other.framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                           picture_.texture.name(), 0);
    capabilities_.drawBuffers->attachSecond(ambient_.name());
    depthStencil_->attach();
    flip();
    return isDrawable();
}

void AmbientTarget::flip() const {
    if (flipped_) capabilities_.framebufferFlip->flip();
}

void AmbientTarget::bindSurfaces() const {
    glBindFramebuffer(GL_FRAMEBUFFER, both_.name());
}

void AmbientTarget::bindPicture() const {
    glBindFramebuffer(GL_FRAMEBUFFER, picture_.framebuffer.name());
}

void AmbientTarget::takeAmbient() {
    draw(ambient_);
}

void AmbientTarget::show(gl::Name framebuffer) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_BLEND);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    draw(picture_.texture);
    glEnable(GL_DEPTH_TEST);
}

void AmbientTarget::draw(const gl::Texture& texture) {
    if (!copy_) copy_.emplace(shaders::copy_frag);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texture.name());
    const gl::Program& program = copy_->use();
    program.setSampler("u_picture", 0);
    const glm::vec2 texel = 1.0f / glm::vec2(size_);
    program.set("u_texelFromPixel",
                flipped_ ? glm::vec4(texel.x, -texel.y, 0.0f, 1.0f) : glm::vec4(texel, 0.0f, 0.0f));
    copy_->draw();
    glBindTexture(GL_TEXTURE_2D, 0);
}

std::size_t AmbientTarget::bytes() const {
    const auto pixels = static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y);
    return 8 * pixels + (depthStencil_ ? depthStencil_->bytes() : 0);
}

} // namespace edgeshade
