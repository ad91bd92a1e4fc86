#pragma once

#include "src/gl/capabilities.hpp"
#include "src/gl/objects.hpp"
#include "src/render/drawing/whole_picture.hpp"
#include "src/render/irregular/surface_numbers.hpp"
#include "src/scene/gpu_scene.hpp"
#include "src/shadow/geometry/pixel_rectangle.hpp"
#include "src/shadow/irregular/irregular_z_buffer.hpp"
#include "src/shadow/view/frame_view.hpp"

#include <map>

namespace edgeshade {

/// Shadows by an IrregularZBuffer, which the processor asks of each visible point whether something
/// is between it and the light: exact as volumes are, and nothing is filled (docs/method.md, C46).
class IrregularShadowPass {
  public:
    explicit IrregularShadowPass(const gl::Capabilities& capabilities);

    /// The framebuffer shows other surfaces from now on.
    void forgetSurfaces() { known_ = false; }

    /// Marks what of a slice's surfaces in the current framebuffer is in the light's shadow: the
    /// stencil, which must be 0, is not 0 there. Colour and depth masks are the caller's state, as
    /// are the viewport, the picture's, and the scissor, which is `reach`. `area`: the same for any
    /// light of the slice, and around `reach`. Leaves the depth test on, the stencil's test on.
    /// Throws Error(unavailable) where the GL can't tell what each pixel shows.
    /// `animatedAlone`: casters that no animation moves are looked up elsewhere.
    void mark(const GpuScene& scene, const FrameView& view, const DepthSlice& slice,
              const Light& light, const PixelRectangle& reach, const PixelRectangle& area,
              bool animatedAlone);

    /// On the GPU.
    std::size_t bytes() const {
        return static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y) +
               numbers_.bytes();
    }

  private:
    /// The casters of a geometry, as long as batches have it.
    struct Kept {
        CopyOnWrite<Geometry> geometry; ///< it is shared, so that nobody edits it in place
        std::shared_ptr<const int> scene;
        CasterRuns casters{};
        bool used = true;
    };
    std::vector<PlacedRuns> castersOf(const GpuScene& scene, bool animatedAlone);
    void upload(const std::vector<std::uint8_t>& marked);

    SurfaceNumbers numbers_;
    WholePicture picture_;
    gl::Texture texture_;
    glm::ivec2 size_{0}; ///< the texture's
    SeenTriangles seen_;
    bool known_ = false; ///< it is what the framebuffer shows
    std::map<const Geometry*, Kept> kept_;
};

} // namespace edgeshade
