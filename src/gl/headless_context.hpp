#pragma once

#include "src/gl/capabilities.hpp"
#include "src/gl/multisampling.hpp"
#include "src/gl/reset_status.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace edgeshade::gl {

/// An OpenGL ES 2 context with a picture of its own and no display, by EGL.
///
/// Takes the first of: a hardware device (EGL_EXT_platform_device), Mesa without a surface, the
/// default display. The picture is a pbuffer with 8-bit RGBA, depth and stencil, drawn through a
/// multisampled framebuffer where samples are asked for (Mesa ignores them in pbuffers). Current
/// on the thread that made it until it is destroyed.
class HeadlessContext {
  public:
    struct Request {
        int width = 1;
        int height = 1;
        int samples = 0; ///< 0: no antialiasing
        Limits limits = Limits::device;
        int depthBits = 24; ///< at least; 16 if there is no more
    };

    /// Throws Error(unavailable) that says what is missing.
    explicit HeadlessContext(const Request& request);
    ~HeadlessContext();
    HeadlessContext(const HeadlessContext&) = delete;
    HeadlessContext& operator=(const HeadlessContext&) = delete;

    const Capabilities& capabilities() const { return capabilities_; }
    int width() const { return width_; }
    int height() const { return height_; }

    /// The picture, RGBA, rows top to bottom. Throws Error(unavailable) if the context was lost.
    std::vector<std::uint8_t> readPixels() const { return readPixels(width_, height_); }
    /// Its lower left part, which is where smaller views are drawn.
    std::vector<std::uint8_t> readPixels(int width, int height) const;

  private:
    void makeCurrent(void* config);
    void release();

    void* display_ = nullptr;
    void* context_ = nullptr;
    void* surface_ = nullptr;
    int width_ = 0;
    int height_ = 0;
    Capabilities capabilities_;
    std::optional<ResetStatus> reset_; ///< where the context tells
    std::optional<MultisampledFramebuffer> multisampled_;
};

} // namespace edgeshade::gl
