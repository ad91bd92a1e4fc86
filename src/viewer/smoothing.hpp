#pragma once

#include "src/gl/depth_stencil.hpp"
#include "src/gl/framebuffer_keeper.hpp"
#include "src/render/accumulation/picture_sum.hpp"
#include "src/render/accumulation/subpixels.hpp"

namespace edgeshade::viewer {

/// Antialiasing while nothing moves: pictures sampled here and there within their pixels, one
/// between two frames, whose mean is shown after 4 of them, 16, 64 and so on, and after the last.
class Smoothing {
  public:
    explicit Smoothing(const gl::Capabilities& capabilities) : capabilities_(capabilities) {}

    /// `picture` counts the changes of what is seen. Starts anew unless all are what they were.
    /// `of`: pictures, at most mostSubpixels; 0: none.
    void see(std::size_t picture, std::size_t of, const glm::ivec2& size);

    bool wantsMore() const { return done_ < of_; }

    /// Where within its pixels the next picture is sampled.
    glm::dvec2 offset() const { return subpixelOffset(done_); }

    /// Adds what draw() draws into the framebuffer that is bound then. Returns whether a better
    /// picture can be shown. Throws Error.
    template <class Draw>
    bool add(Draw draw) {
        const gl::FramebufferKeeper keeper;
        begin();
        draw();
        return end();
    }

    /// Draws the mean into the framebuffer that is bound.
    void show() const;

    std::size_t shown() const { return shown_; } ///< pictures; 0: the usual one is to be drawn
    std::size_t of() const { return of_; }
    std::size_t bytes() const;

  private:
    void begin();
    bool end();

    gl::Capabilities capabilities_;
    gl::ColorTarget drawn_;
    std::optional<gl::DepthStencil>
        depthStencil_; ///< none: drawn where the caller does, and copied
    PictureSum sum_;
    glm::ivec2 size_{0};
    std::size_t picture_ = 0, done_ = 0, shown_ = 0, of_ = 0;
};

} // namespace edgeshade::viewer
