#include "src/gl/multisampling.hpp"

#include "preprocess/base/error.hpp"
#include "src/gl/entry_points.hpp"

#include <GLES2/gl2.h>
#include <GLES2/gl2ext.h>

namespace edgeshade::gl {
namespace {

// The same values in ES 3.0 and in both extensions.
constexpr GLenum readFramebuffer = 0x8CA8;
constexpr GLenum drawFramebuffer = 0x8CA9;
constexpr GLenum largestSamples = 0x8D57;

[[noreturn]] void unavailable(int samples) {
    throw Error(ExitStatus::unavailable,
                "This GL can't draw with " + std::to_string(samples) + " samples a pixel.");
}

} // namespace

std::optional<Multisampling> Multisampling::find(const std::string& version,
                                                 const std::string& extensions,
                                                 void* (*lookUp)(const char*)) {
    const auto suffix = entryPointSuffix(version, extensions, "framebuffer_multisample");
    if (!suffix) return std::nullopt;
    Multisampling found;
    found.storage_ =
        reinterpret_cast<Storage>(lookUp(("glRenderbufferStorageMultisample" + *suffix).c_str()));
    found.blit_ = reinterpret_cast<Blit>(lookUp(("glBlitFramebuffer" + *suffix).c_str()));
    if (!found.storage_ || !found.blit_) return std::nullopt;
    return found;
}

void Multisampling::average(Name from, Name into, int width, int height) const {
    glBindFramebuffer(readFramebuffer, from);
    glBindFramebuffer(drawFramebuffer, into);
    blit_(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, into);
    requireNoError("averaging samples");
}

MultisampledFramebuffer::MultisampledFramebuffer(int width, int height, int samples,
                                                 const std::string& version,
                                                 const std::string& extensions,
                                                 void* (*lookUp)(const char*))
    : width_(width), height_(height) {
    const auto found = Multisampling::find(version, extensions, lookUp);
    GLint most = 0;
    if (found) glGetIntegerv(largestSamples, &most);
    if (samples > most) unavailable(samples);
    multisampling_ = *found;

    Name names[2] = {};
    glGenRenderbuffers(2, names);
    color_ = Renderbuffer(names[0]);
    depthStencil_ = Renderbuffer(names[1]);
    glBindRenderbuffer(GL_RENDERBUFFER, color_.name());
    multisampling_.makeStorage(samples, GL_RGBA8_OES, width, height);
    glGetRenderbufferParameteriv(GL_RENDERBUFFER, 0x8CAB /* RENDERBUFFER_SAMPLES */, &samples_);
    glBindRenderbuffer(GL_RENDERBUFFER, depthStencil_.name());
    multisampling_.makeStorage(samples, GL_DEPTH24_STENCIL8_OES, width, height);

    Name framebuffer = 0;
    glGenFramebuffers(1, &framebuffer);
    framebuffer_ = Framebuffer(framebuffer);
    bind();
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color_.name());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER,
                              depthStencil_.name());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_STENCIL_ATTACHMENT, GL_RENDERBUFFER,
                              depthStencil_.name());
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    if (const GLenum error = glGetError(); error == GL_OUT_OF_MEMORY || error == contextLost)
        requireNoError(error, "making a framebuffer with several samples a pixel");
    else if (error != GL_NO_ERROR || status != GL_FRAMEBUFFER_COMPLETE)
        unavailable(samples);
}

void MultisampledFramebuffer::resolve() const {
    multisampling_.average(framebuffer_.name(), 0, width_, height_);
}

void MultisampledFramebuffer::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
}

} // namespace edgeshade::gl
