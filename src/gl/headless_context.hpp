#pragma once

#include "src/gl/capabilities.hpp"
#include "src/gl/egl_display.hpp"
#include "src/gl/multisampling.hpp"
#include "src/gl/reset_status.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace edgeshade::gl {

/// An OpenGL ES 2 context by EGL with its own picture and without a display.
///
/// Uses the first available of: a hardware device (EGL_EXT_platform_device), Mesa without a
/// surface, the default display. The picture is a pbuffer with 8-bit RGBA, depth and stencil. If
/// samples are requested it is drawn through a multisampled framebuffer, as Mesa ignores them in
/// pbuffers. The context is current on the thread that created it until it is destroyed. Then the
/// context that was current before is so again. Contexts live beside each other and beside the
/// application's.
class HeadlessContext {
  public:
    struct Request {
        int width = 1;
        int height = 1;
        int samples = 0; ///< 0: no antialiasing
        Limits limits = Limits::device;
        int depthBits = 24; ///< at least; 16 if no more is available
    };

    /// Throws Error(unavailable) naming what is missing.
    explicit HeadlessContext(const Request& request);
    ~HeadlessContext();
    HeadlessContext(const HeadlessContext&) = delete;
    HeadlessContext& operator=(const HeadlessContext&) = delete;

    const Capabilities& capabilities() const { return capabilities_; }
    int width() const { return width_; }
    int height() const { return height_; }

    /// The picture, RGBA, rows top to bottom. Throws Error(unavailable) if the context was lost.
    std::vector<std::uint8_t> readPixels() const { return readPixels(width_, height_); }
    /// The lower left part of the picture, where smaller views are drawn.
    std::vector<std::uint8_t> readPixels(int width, int height) const;

  private:
    void makeCurrent(void* config);
    void release();

    std::shared_ptr<void> display_;
    CurrentContext before_; ///< the one that was current before
    void* context_ = nullptr;
    void* surface_ = nullptr;
    int width_ = 0;
    int height_ = 0;
    Capabilities capabilities_;
    std::optional<ResetStatus> reset_; ///< null: the context doesn't report its loss
    std::optional<MultisampledFramebuffer> multisampled_;
};

} // namespace edgeshade::gl
