#pragma once

#include "src/gl/depth_stencil.hpp"
#include "src/gl/framebuffer_keeper.hpp"
#include "src/render/accumulation/picture_sum.hpp"
#include "src/render/accumulation/subpixels.hpp"

namespace edgeshade::viewer {

/// Antialiasing while nothing moves: adds one picture between two frames, each sampled at another
/// place within the pixels. The mean is shown after 4, 16, 64 ... pictures and after the last one.
class Smoothing {
  public:
    explicit Smoothing(const gl::Capabilities& capabilities) : capabilities_(capabilities) {}

    /// `picture` counts changes of the picture. Restarts unless all arguments are the same as
    /// before. `of`: number of pictures, at most mostSubpixels; 0: no smoothing.
    void see(std::size_t picture, std::size_t of, const glm::ivec2& size);

    bool wantsMore() const { return done_ < of_; }

    /// Where within the pixels the next picture is sampled.
    glm::dvec2 offset() const { return subpixelOffset(done_); }

    /// Calls draw() and adds its picture, drawn into the framebuffer bound at that moment. Returns
    /// whether a better picture can be shown. Throws Error.
    template <class Draw>
    bool add(Draw draw) {
        const gl::FramebufferKeeper keeper;
        begin();
        draw();
        return end();
    }

    /// Draws the mean into the bound framebuffer.
    void show() const;

    std::size_t shown() const { return shown_; } ///< pictures; 0: the usual picture must be drawn
    std::size_t of() const { return of_; }
    std::size_t bytes() const;

  private:
    void begin();
    bool end();

    gl::Capabilities capabilities_;
    gl::ColorTarget drawn_;
    std::optional<gl::DepthStencil>
        depthStencil_; ///< empty: pictures are drawn into the caller's framebuffer and copied
    PictureSum sum_;
    glm::ivec2 size_{0};
    std::size_t picture_ = 0, done_ = 0, shown_ = 0, of_ = 0;
};

} // namespace edgeshade::viewer
