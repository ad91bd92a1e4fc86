#pragma once

#include "src/gl/capabilities.hpp"
#include "src/gl/color_target.hpp"
#include "src/gl/depth_stencil.hpp"
#include "src/render/drawing/whole_picture.hpp"
#include "src/render/volumes/render_settings.hpp"
#include "src/scene/gpu_scene.hpp"
#include "src/shadow/geometry/frame_view.hpp"

#include <glm/glm.hpp>

namespace edgeshade {

/// Framebuffers in which surfaces are drawn in two colours at once, in light and by ambient light
/// alone, so that what is found to be in shadow takes the second and isn't drawn again.
class AmbientTarget {
  public:
    /// Whether the settings ask for it and the GL can. Throws Error(unavailable) where they insist
    /// and it can't.
    static bool isWanted(const RenderSettings& settings, const gl::Capabilities& capabilities);

    /// Whether to draw the scene's surfaces takes longer than to write all pixels some times more.
    static bool pays(const GpuScene& scene, const FrameView& view);

    explicit AmbientTarget(const gl::Capabilities& capabilities) : capabilities_(capabilities) {}

    /// Makes it that large, for the framebuffer that is bound, which stays. Returns whether the GL
    /// draws into it.
    bool fit(int width, int height);

    /// For surfaces, which must write both colours (SurfaceShading::withAmbientTarget).
    void bindSurfaces() const;

    /// For all else, with their depths and the same stencil: the picture alone.
    void bindPicture() const;

    /// Takes the ambient colours into the picture, which must be bound, where the caller's stencil,
    /// scissor and depth say.
    void takeAmbient();

    /// Draws the picture over the whole viewport of that framebuffer.
    void show(gl::Name framebuffer);

    std::size_t bytes() const;

  private:
    bool make(int width, int height);
    void flip() const;
    void draw(const gl::Texture& texture);

    gl::Capabilities capabilities_;
    glm::ivec2 size_{0};
    bool flipped_ = false; ///< rows lie as in the default framebuffer
    bool refused_ = false; ///< the GL can't after all
    gl::ColorTarget picture_;
    gl::Texture ambient_;
    gl::Framebuffer both_;
    std::optional<gl::DepthStencil> depthStencil_;
    std::optional<WholePicture> copy_; ///< once something was copied
};

} // namespace edgeshade
