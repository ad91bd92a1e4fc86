#include "src/gl/objects.hpp"

#include "preprocess/base/error.hpp"
#include "src/gl/platform.hpp"

#include <GLES2/gl2.h>

namespace edgeshade::gl {

void deleteBuffer(Name name) {
    glDeleteBuffers(1, &name);
}
void deleteTexture(Name name) {
    glDeleteTextures(1, &name);
}
void deleteShader(Name name) {
    glDeleteShader(name);
}
void deleteProgram(Name name) {
    glDeleteProgram(name);
}

void deleteFramebuffer(Name name) {
    glDeleteFramebuffers(1, &name);
}
void deleteRenderbuffer(Name name) {
    glDeleteRenderbuffers(1, &name);
}

/// Bytes below which browsers don't check for lack of memory, as glGetError() waits there until all
/// drawing is done.
constexpr std::size_t surelyThere = inBrowser ? 4u << 20 : 0;

Buffer::Buffer(Kind kind, std::span<const std::byte> bytes) : size_(bytes.size()) {
    const GLenum target = kind == Kind::vertices ? GL_ARRAY_BUFFER : GL_ELEMENT_ARRAY_BUFFER;
    Name name = 0;
    glGenBuffers(1, &name);
    object_ = Owned<deleteBuffer>(name);
    glBindBuffer(target, name);
    glBufferData(target, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STATIC_DRAW);
    glBindBuffer(target, 0);
    if (bytes.size() >= surelyThere) requireNoError("uploading a buffer");
}

int integerOf(unsigned name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

Name boundFramebuffer() {
    return static_cast<Name>(integerOf(GL_FRAMEBUFFER_BINDING));
}

Texture nearestTexture() {
    Name name = 0;
    glGenTextures(1, &name);
    Texture texture(name);
    glBindTexture(GL_TEXTURE_2D, name);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
    return texture;
}

Texture makeTexture(std::span<const std::uint8_t> rgba, int width, int height,
                    const Sampler& sampler) {
    Name name = 0;
    glGenTextures(1, &name);
    Texture texture(name);
    glBindTexture(GL_TEXTURE_2D, name);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 rgba.data());
    if (sampler.takesMipmaps()) glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, sampler.minFilter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, sampler.magFilter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, sampler.wrapS);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, sampler.wrapT);
    glBindTexture(GL_TEXTURE_2D, 0);
    requireNoError("uploading a texture");
    return texture;
}

void requireNoError(const char* doing) {
    requireNoError(glGetError(), doing);
}

void requireNoError(unsigned error, const char* doing) {
    if (error == GL_NO_ERROR) return;
    const char* what = error == GL_OUT_OF_MEMORY ? "the GL is out of memory"
                       : error == contextLost    ? "the GL has lost its context, its driver was "
                                                   "reset or its device is gone"
                                                 : "the GL reports an error";
    throw Error(ExitStatus::unavailable, std::string("While ") + doing + ": " + what + " (code " +
                                             std::to_string(error) + ").");
}

} // namespace edgeshade::gl
