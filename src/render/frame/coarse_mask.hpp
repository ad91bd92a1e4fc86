#pragma once

#include "src/gl/color_target.hpp"
#include "src/gl/depth_stencil.hpp"
#include "src/shadow/view/frame_view.hpp"

#include <optional>

namespace edgeshade {

/// How planes are stored: see shaders_es2/coarse_plane.glsl.
struct PlaneSpace {
    glm::vec2 tangents{1.0f}; ///< half the picture's window, across and up, see Frustum
    glm::vec2 middle{0.0f};   ///< of the window
    glm::vec2 focal{1.0f};    ///< fragments a unit of the window
    float near = 1.0f;
    std::optional<float> depthRange{}; ///< of orthographic pictures, from near to far plane
};

/// A light's finished mask of lower resolution, with what a fragment needs to look itself up in it.
struct CoarseMaskLookup {
    gl::Name surface = 0; ///< texture: the texels' planes
    gl::Name lit = 0;     ///< texture: alpha 1 where the light reaches the texel
    PlaneSpace space;
    glm::vec2 size{1.0f};  ///< texels
    glm::vec2 texel{1.0f}; ///< a texel's size in fragments
    float slack = 0.0f;    ///< by which a surface may leave its plane; see the shader
    glm::vec4 light{0.0f}; ///< in the space of planes
};

/// Where shadow volumes are counted at a lower resolution than the picture's (`--mask-scale`): a
/// framebuffer for the surfaces' depths and planes, and one for what the stencil then says, with
/// depth and stencil in common. Surfaces are drawn once a depth slice, counts once a light.
class CoarseMask {
  public:
    /// A texel for `scale` x `scale` pixels. Throws Error(unavailable) where shaders have no
    /// derivatives.
    CoarseMask(int scale, const gl::Capabilities& capabilities);

    /// Makes room for a picture of this size. Changes the framebuffer binding. Throws
    /// Error(unavailable) if the GL can't.
    void fit(int width, int height);

    /// Binds one of the framebuffers and sets the viewport. They have no scissor of their own.
    void bindSurfaces() const;
    void bindCounts() const;

    glm::ivec2 size() const { return size_; } ///< texels
    PlaneSpace space(const FrameView& view, const DepthSlice& slice) const;
    CoarseMaskLookup lookup(const FrameView& view, const DepthSlice& slice,
                            const Light& light) const;
    std::size_t bytes() const;

  private:
    gl::ColorTarget makeTarget(const glm::ivec2& size) const;

    int scale_;
    gl::Capabilities capabilities_;
    glm::ivec2 size_{0};
    std::optional<gl::DepthStencil> depthStencil_;
    gl::ColorTarget surfaces_, counts_;
};

} // namespace edgeshade
