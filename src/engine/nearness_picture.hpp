#pragma once

#include "edgeshade/shadow_masks.hpp"
#include "src/render/drawing/nearness_target.hpp"
#include "src/render/frame/frame.hpp"

namespace edgeshade {

/// The nearness of each pixel's surface, as a texture for hosts (MaskNearness).
class NearnessPicture {
  public:
    explicit NearnessPicture(const gl::Capabilities& capabilities) : target_(capabilities) {}

    /// `asked`: the frustum that the host requested; `shared`: depth to draw with, null: its own.
    /// Leaves its framebuffer bound. Throws Error(unavailable) if the GL can't draw so.
    void draw(Renderer& renderer, const GpuScene& scene, const FrameView& view,
              const Frustum& asked, const gl::DepthStencil* shared = nullptr);

    /// Makes the picture, if it has another size.
    void fit(int width, int height) { target_.bind(width, height); }

    const MaskNearness& told() const { return told_; }
    std::size_t bytes() const { return target_.bytes(); }

  private:
    NearnessTarget target_;
    MaskNearness told_;
};

} // namespace edgeshade
