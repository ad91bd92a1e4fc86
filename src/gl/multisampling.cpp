#include "src/gl/multisampling.hpp"

#include "preprocess/base/error.hpp"
#include "src/gl/entry_points.hpp"
#include "src/gl/framebuffer_targets.hpp"

#include <GLES2/gl2.h>
#include <GLES2/gl2ext.h>

namespace edgeshade::gl {
namespace {

// ES 3.0 and both extensions use the same value.
constexpr GLenum largestSamples = 0x8D57;

[[noreturn]] void unavailable(int samples) {
    throw Error(ExitStatus::unavailable,
                "This GL can't draw with " + std::to_string(samples) + " samples per pixel.");
}

} // namespace

std::optional<Multisampling> Multisampling::find(const std::string& version,
                                                 const std::string& extensions,
                                                 void* (*lookUp)(const char*)) {
    const auto suffix = entryPointSuffix(version, extensions, "framebuffer_multisample");
    if (!suffix) return std::nullopt;
    Multisampling found;
    const bool complete =
        takeEntryPoint(found.storage_, lookUp, "glRenderbufferStorageMultisample" + *suffix) &&
        takeEntryPoint(found.blit_, lookUp, "glBlitFramebuffer" + *suffix);
    return complete ? std::optional(found) : std::nullopt;
}

void Multisampling::average(Name from, Name into, int width, int height) const {
    glBindFramebuffer(readFramebuffer, from);
    glBindFramebuffer(drawFramebuffer, into);
    blit_(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, into);
    requireNoError("averaging samples");
}

SampledBuffers::SampledBuffers(const Multisampling& multisampling, int samples, unsigned format,
                               int width, int height) {
    const auto make = [&](unsigned as) {
        Name name = 0;
        glGenRenderbuffers(1, &name);
        Renderbuffer buffer(name);
        glBindRenderbuffer(GL_RENDERBUFFER, name);
        multisampling.makeStorage(samples, as, width, height);
        return buffer;
    };
    color_ = make(format);
    glGetRenderbufferParameteriv(GL_RENDERBUFFER, 0x8CAB /* RENDERBUFFER_SAMPLES */, &samples_);
    depthStencil_ = make(GL_DEPTH24_STENCIL8_OES);
    glBindRenderbuffer(GL_RENDERBUFFER, 0);
    const auto attach = [](GLenum attachment, const Renderbuffer& buffer) {
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer.name());
    };
    attach(GL_COLOR_ATTACHMENT0, color_);
    attach(GL_DEPTH_ATTACHMENT, depthStencil_);
    attach(GL_STENCIL_ATTACHMENT, depthStencil_);
}

MultisampledFramebuffer::MultisampledFramebuffer(int width, int height, int samples,
                                                 const std::string& version,
                                                 const std::string& extensions,
                                                 void* (*lookUp)(const char*))
    : width_(width), height_(height) {
    const auto found = Multisampling::find(version, extensions, lookUp);
    if (samples > (found ? integerOf(largestSamples) : 0)) unavailable(samples);
    multisampling_ = *found;

    Name framebuffer = 0;
    glGenFramebuffers(1, &framebuffer);
    framebuffer_ = Framebuffer(framebuffer);
    bind();
    buffers_ = SampledBuffers(multisampling_, samples, GL_RGBA8_OES, width, height);
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    if (const GLenum error = glGetError(); error == GL_OUT_OF_MEMORY || error == contextLost)
        requireNoError(error, "making a framebuffer with several samples per pixel");
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
