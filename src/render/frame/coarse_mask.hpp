#pragma once

#include "src/gl/color_target.hpp"
#include "src/gl/depth_stencil.hpp"
#include "src/shadow/view/frame_view.hpp"

#include <optional>

namespace edgeshade {

/// The space in which planes are stored, see shaders_es2/coarse_plane.glsl.
struct PlaneSpace {
    glm::vec2 tangents{1.0f}; ///< half the picture's window, to the right and up, see Frustum
    glm::vec2 middle{0.0f};   ///< the window's middle
    glm::vec2 focal{1.0f};    ///< fragments per unit of the window
    float near = 1.0f;
    std::optional<float> depthRange{}; ///< orthographic only: depth from the near to the far plane
};

/// A light's finished mask of lower resolution, with the data that fragments need to sample it.
struct CoarseMaskLookup {
    gl::Name surface = 0; ///< texture: the texels' planes
    gl::Name lit = 0;     ///< texture: alpha 1 where the light reaches the texel
    PlaneSpace space;
    glm::vec2 size{1.0f};  ///< in texels
    glm::vec2 texel{1.0f}; ///< size of a texel in fragments
    float slack = 0.0f;    ///< how far a surface may leave its plane; see the shader
    glm::vec4 light{0.0f}; ///< in the planes' space
};

/// Framebuffers for counting shadow volumes at a lower resolution than the picture's
/// (`--mask-scale`): one for the surfaces' depths and planes, and one for the counted result. They
/// share depth and stencil. Surfaces are drawn once per depth slice, counts once per light.
class CoarseMask {
  public:
    /// One texel covers `scale` x `scale` pixels. Throws Error(unavailable) if shaders have no
    /// derivatives.
    CoarseMask(int scale, const gl::Capabilities& capabilities);

    /// Makes room for a picture of this size. Changes the framebuffer binding. Throws
    /// Error(unavailable) if the GL can't.
    void fit(int width, int height);

    /// Bind one of the framebuffers and set the viewport, but no scissor.
    void bindSurfaces() const;
    void bindCounts() const;

    glm::ivec2 size() const { return size_; } ///< in texels
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
