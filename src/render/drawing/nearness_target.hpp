#pragma once

#include "src/gl/color_target.hpp"
#include "src/gl/depth_stencil.hpp"

#include <optional>

namespace edgeshade {

/// The target of Renderer::drawNearness(): a texture, and depth.
class NearnessTarget {
  public:
    explicit NearnessTarget(const gl::Capabilities& capabilities) : capabilities_(capabilities) {}

    /// Binds its framebuffer, recreating it if the size changed. `shared`: depth of that size to
    /// draw with, which others go on to use; null: its own. Throws Error(unavailable) if the GL
    /// can't draw this way.
    void bind(int width, int height, const gl::DepthStencil* shared = nullptr);

    gl::Name texture() const { return target_.texture.name(); }
    std::size_t bytes() const;

  private:
    void fit(int width, int height);
    void attachDepthAlone(int width, int height);

    gl::Capabilities capabilities_;
    gl::ColorTarget target_;
    std::optional<gl::DepthStencil> depth_;
    gl::Renderbuffer depthAlone_; ///< replaces `depth_` if a framebuffer can't have both
    int width_ = 0, height_ = 0;
};

} // namespace edgeshade
