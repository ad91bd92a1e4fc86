#pragma once

#include "src/gl/capabilities.hpp"
#include "src/gl/objects.hpp"
#include "src/render/shadow_map.hpp"

namespace edgeshade {

/// What a shadow map is drawn into: an RGBA8 texture, a cube's six faces or one, and a depth buffer
/// that they share. Needs no extension; uses 24 bits of depth where it can.
class ShadowMapTarget {
  public:
    /// Changes the framebuffer binding. Throws Error(unavailable) if the GL can't.
    ShadowMapTarget(ShadowMapKind kind, int size, const gl::Capabilities& capabilities);

    /// Binds a face for drawing. The viewport is the caller's.
    void bindFace(std::size_t face) const;

    gl::Name texture() const { return texture_.name(); }
    int depthBits() const { return depthBits_; }
    std::size_t bytes() const;

  private:
    ShadowMapKind kind_;
    int size_;
    int depthBits_ = 0;
    gl::Texture texture_;
    gl::Renderbuffer depth_;
    gl::Framebuffer framebuffer_;
};

/// Throws Error(unavailable) if maps of this size are more than the GL can hold.
void requireMapSize(int size);

} // namespace edgeshade
