#pragma once

#include "edgeshade/shadow_masks.hpp"
#include "src/gl/color_target.hpp"
#include "src/gl/depth_stencil.hpp"
#include "src/render/frame/frame.hpp"

#include <optional>

namespace edgeshade {

/// How near what each pixel shows is, as a texture for hosts (MaskNearness).
class NearnessPicture {
  public:
    explicit NearnessPicture(const gl::Capabilities& capabilities) : capabilities_(capabilities) {}

    /// `asked`: what the view was made for. Leaves its framebuffer bound. Throws
    /// Error(unavailable) if the GL can't draw so.
    void draw(Renderer& renderer, const GpuScene& scene, const FrameView& view,
              const Frustum& asked);

    const MaskNearness& told() const { return told_; }
    std::size_t bytes() const;

  private:
    void fit(int width, int height);

    gl::Capabilities capabilities_;
    gl::ColorTarget target_;
    std::optional<gl::DepthStencil> depth_;
    int width_ = 0, height_ = 0;
    MaskNearness told_;
};

} // namespace edgeshade
