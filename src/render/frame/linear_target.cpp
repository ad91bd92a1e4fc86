#include "src/render/frame/linear_target.hpp"

#include "shaders_es2.hpp"
#include "src/scene/srgb.hpp"

#include <algorithm>
#include <cmath>
#include <GLES2/gl2.h>
#include <GLES2/gl2ext.h>

namespace edgeshade {
namespace {

constexpr GLenum rgba16f = 0x881A;
constexpr GLenum halfFloat = 0x140B; ///< the value of ES 3.0; OES_texture_half_float has another

void attachTexture(gl::Name texture) {
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
}

gl::Framebuffer makeFramebuffer() {
    gl::Name name = 0;
    glGenFramebuffers(1, &name);
    glBindFramebuffer(GL_FRAMEBUFFER, name);
    return gl::Framebuffer(name);
}

/// Whether the framebuffer is complete. Also clears the error if the GL refused something.
bool isComplete() {
    const bool refused = glGetError() != GL_NO_ERROR;
    return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE && !refused;
}

} // namespace

bool LinearTarget::isPossible(const gl::Capabilities& capabilities) {
    const bool draws = capabilities.has("GL_EXT_color_buffer_half_float") ||
                       capabilities.has("GL_EXT_color_buffer_float");
    const bool holds = capabilities.has("GL_OES_texture_half_float") ||
                       capabilities.version.starts_with("OpenGL ES 3");
    return draws && holds;
}

bool LinearTarget::bind(int width, int height) {
    if (refused_) return false;
    const gl::Name bound = gl::boundFramebuffer();
    if (size_ != glm::ivec2(width, height) && !make(width, height)) {
        refused_ = true;
        glBindFramebuffer(GL_FRAMEBUFFER, bound);
        return false;
    }
    glBindFramebuffer(GL_FRAMEBUFFER, sampled_.name() ? sampled_.name() : framebuffer_.name());
    return true;
}

bool LinearTarget::make(int width, int height) {
    size_ = {width, height};
    sampled_ = {};
    depthStencil_.reset();
    const bool made = makeTexture(GL_RGBA, GL_HALF_FLOAT_OES) || makeTexture(rgba16f, halfFloat);
    if (!made) return false;
    if (capabilities_.samples > 1 && capabilities_.multisampling) return makeSamples();
    depthStencil_.emplace(width, height, capabilities_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    depthStencil_->attach();
    return isComplete();
}

bool LinearTarget::makeTexture(unsigned internalFormat, unsigned type) {
    glActiveTexture(GL_TEXTURE0);
    light_ = gl::nearestTexture();
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internalFormat), size_.x, size_.y, 0, GL_RGBA,
                 type, nullptr);
    glBindTexture(GL_TEXTURE_2D, 0);
    framebuffer_ = makeFramebuffer();
    attachTexture(light_.name());
    return isComplete();
}

bool LinearTarget::makeSamples() {
    sampled_ = makeFramebuffer();
    samples_ = gl::SampledBuffers(*capabilities_.multisampling, capabilities_.samples, rgba16f,
                                  size_.x, size_.y);
    return isComplete();
}

void LinearTarget::show(gl::Name framebuffer) {
    if (sampled_.name())
        capabilities_.multisampling->average(sampled_.name(), framebuffer_.name(), size_.x,
                                             size_.y);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_BLEND);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    if (!picture_) picture_.emplace(shaders::show_light_frag);
    const gl::Program& program = picture_->use();
    program.setTexture("u_light", 0, light_.name());
    program.set("u_size", 1.0f / glm::vec2(size_));
    picture_->draw();
    glBindTexture(GL_TEXTURE_2D, 0);
    glEnable(GL_DEPTH_TEST);
}

/// The same formula as in tone_inverse.glsl.
glm::vec3 LinearTarget::lightShownAs(const glm::vec3& color) {
    constexpr float reflected = 0.04f, shown = 0.8f - reflected;
    glm::vec3 light = linearFromSrgb(color);
    const float most = std::max({light.r, light.g, light.b});
    if (most > shown) {
        constexpr float room = 1.0f - shown;
        light *= (room * room / (1.0f - std::min(most, 0.999f)) + shown - room) / most;
    }
    const float least = std::min({light.r, light.g, light.b});
    return light + (least < reflected ? 2.0f * std::sqrt(reflected * least) - least : reflected);
}

std::size_t LinearTarget::bytes() const {
    const auto pixels = static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y);
    const std::size_t samples =
        sampled_.name() ? static_cast<std::size_t>(capabilities_.samples) * 12 : 0;
    return pixels * (8 + samples) + (depthStencil_ ? depthStencil_->bytes() : 0);
}

} // namespace edgeshade
