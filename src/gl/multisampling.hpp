#pragma once

#include "src/gl/objects.hpp"

#include <optional>
#include <string>

namespace edgeshade::gl {

/// Renderbuffers with several samples a pixel, and their resolve. GLES 2 has them only as an
/// extension: core names from ES 3.0 on, otherwise GL_ANGLE_framebuffer_multisample or
/// GL_NV_framebuffer_multisample.
class Multisampling {
  public:
    /// Null if the GL has none of these.
    static std::optional<Multisampling>
    find(const std::string& version, const std::string& extensions, void* (*lookUp)(const char*));

    /// Allocates storage for the bound renderbuffer.
    void makeStorage(int samples, unsigned format, int width, int height) const {
        storage_(0x8D41 /* RENDERBUFFER */, samples, format, width, height);
    }
    /// Averages the samples of one framebuffer into another of the same size, and leaves the latter
    /// bound.
    void average(Name from, Name into, int width, int height) const;

  private:
    using Storage = void (*)(unsigned, int, unsigned, int, int);
    using Blit = void (*)(int, int, int, int, int, int, int, int, unsigned, unsigned);

    Storage storage_ = nullptr;
    Blit blit_ = nullptr;
};

/// The attachments of a multisampled framebuffer: colour, and depth with an 8-bit stencil.
class SampledBuffers {
  public:
    SampledBuffers() = default;
    /// Creates both and attaches them to the bound framebuffer, whose status says whether the GL
    /// can draw into it. `format`: the colour's GL enum.
    SampledBuffers(const Multisampling& multisampling, int samples, unsigned format, int width,
                   int height);

    int samples() const { return samples_; } ///< per pixel, as the GL made them

  private:
    Renderbuffer color_;
    Renderbuffer depthStencil_;
    int samples_ = 0;
};

/// A multisampled framebuffer beside the default one.
class MultisampledFramebuffer {
  public:
    /// Creates it and binds it for drawing. Throws Error(unavailable) if this context can't.
    MultisampledFramebuffer(int width, int height, int samples, const std::string& version,
                            const std::string& extensions, void* (*lookUp)(const char*));

    /// Averages the samples into the default framebuffer and binds that for reading.
    void resolve() const;

    /// Binds it for drawing again.
    void bind() const;

    int samples() const { return buffers_.samples(); }

  private:
    Multisampling multisampling_;
    Framebuffer framebuffer_;
    SampledBuffers buffers_;
    int width_ = 0;
    int height_ = 0;
};

} // namespace edgeshade::gl
