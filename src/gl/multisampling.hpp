#pragma once

#include "src/gl/objects.hpp"

#include <string>

namespace edgeshade::gl {

/// A multisampled framebuffer beside the default one, which GLES 2 has only as an extension: core
/// names from ES 3.0 on, else GL_ANGLE_framebuffer_multisample or GL_NV_framebuffer_multisample.
class MultisampledFramebuffer {
  public:
    /// Makes it and binds it for drawing. Throws Error(unavailable) if this context can't.
    MultisampledFramebuffer(int width, int height, int samples, const std::string& version,
                            const std::string& extensions, void* (*lookUp)(const char*));

    /// Averages the samples into the default framebuffer and binds that for reading.
    void resolve() const;

    /// Binds it for drawing again.
    void bind() const;

    int samples() const { return samples_; }

  private:
    using Storage = void (*)(unsigned, int, unsigned, int, int);
    using Blit = void (*)(int, int, int, int, int, int, int, int, unsigned, unsigned);

    Blit blit_ = nullptr;
    Framebuffer framebuffer_;
    Renderbuffer color_;
    Renderbuffer depthStencil_;
    int width_ = 0;
    int height_ = 0;
    int samples_ = 0;
};

} // namespace edgeshade::gl
