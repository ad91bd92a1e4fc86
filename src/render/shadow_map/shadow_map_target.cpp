#include "src/render/shadow_map/shadow_map_target.hpp"

#include "preprocess/base/error.hpp"

#include <algorithm>
#include <GLES2/gl2.h>
#include <GLES2/gl2ext.h>
#include <optional>
#include <string>

namespace edgeshade {
namespace {

GLenum faceTarget(bool cube, std::size_t face) {
    return cube ? GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(face) : GL_TEXTURE_2D;
}

/// Creates a texture of one face, or of a cube's six; null if the GL has no memory for it.
std::optional<gl::Texture> makeMapTexture(bool cube, int width, int size) {
    gl::Name name = 0;
    glGenTextures(1, &name);
    gl::Texture texture(name);
    const GLenum target = cube ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D;
    glBindTexture(target, name);
    for (std::size_t face = 0; face < (cube ? 6u : 1u); ++face)
        glTexImage2D(faceTarget(cube, face), 0, GL_RGBA, width, size, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                     nullptr);
    // Packed distances can't be averaged.
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glBindTexture(target, 0);
    const GLenum error = glGetError();
    if (error == GL_OUT_OF_MEMORY) return std::nullopt;
    gl::requireNoError(error, "making a shadow map");
    return texture;
}

Error tooLarge(int size) {
    return Error(ExitStatus::unavailable,
                 "This GL has no memory for a shadow map of " + std::to_string(size) + " texels.");
}

} // namespace

ShadowMapTarget::ShadowMapTarget(const MapForm& form, int size, int texelWidth,
                                 const gl::Capabilities& capabilities)
    : form_(form), size_(size), width_(texelWidth * size) {
    std::optional<gl::Texture> whole;
    if (form.cube) whole = makeMapTexture(true, width_, size_);
    if (whole) {
        textures_.push_back(std::move(*whole));
    } else {
        form_.cube = false;
        while (static_cast<int>(textures_.size()) < form_.faces) {
            std::optional<gl::Texture> face = makeMapTexture(false, width_, size_);
            if (!face) throw tooLarge(size_);
            textures_.push_back(std::move(*face));
        }
    }

    gl::Name name = 0;
    glGenRenderbuffers(1, &name);
    depth_ = gl::Renderbuffer(name);
    glBindRenderbuffer(GL_RENDERBUFFER, name);
    glRenderbufferStorage(GL_RENDERBUFFER,
                          capabilities.has("GL_OES_depth24") ? GL_DEPTH_COMPONENT24_OES
                                                             : GL_DEPTH_COMPONENT16,
                          width_, size_);
    glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_DEPTH_SIZE, &depthBits_);
    glBindRenderbuffer(GL_RENDERBUFFER, 0);
    gl::requireNoError("making a shadow map");

    glGenFramebuffers(1, &name);
    framebuffer_ = gl::Framebuffer(name);
    bindFace(0);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.name());
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw Error(ExitStatus::unavailable, "This GL can't draw into a shadow map of " +
                                                 std::to_string(size_) + " texels.");
}

void ShadowMapTarget::bindFace(std::size_t face) const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, faceTarget(form_.cube, face),
                           textures_[form_.cube ? 0 : face].name(), 0);
}

std::array<gl::Name, 6> ShadowMapTarget::textures() const {
    std::array<gl::Name, 6> names{};
    for (std::size_t i = 0; i < textures_.size(); ++i)
        names[i] = textures_[i].name();
    return names;
}

std::size_t ShadowMapTarget::bytes() const {
    const std::size_t texels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(size_);
    const std::size_t depthBytes = depthBits_ > 16 ? 4 : 2;
    return texels * (4 * static_cast<std::size_t>(form_.faces) + depthBytes);
}

void requireMapSize(int size, int texelWidth, const gl::Capabilities& capabilities) {
    int largest = std::min(size * texelWidth, capabilities.largestTexture);
    for (const GLenum limit :
         {GL_MAX_TEXTURE_SIZE, GL_MAX_CUBE_MAP_TEXTURE_SIZE, GL_MAX_RENDERBUFFER_SIZE})
        largest = std::min(largest, gl::integerOf(limit));
    GLint viewport[2] = {};
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
    largest = std::min({largest, viewport[0], viewport[1]});
    largest /= texelWidth;
    if (largest < size)
        throw Error(ExitStatus::unavailable, "A shadow map of " + std::to_string(size) +
                                                 " texels is too large here; the largest is " +
                                                 std::to_string(largest) + ".");
}

} // namespace edgeshade
