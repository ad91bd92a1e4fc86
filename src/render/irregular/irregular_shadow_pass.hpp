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

/// Shadows from an IrregularZBuffer: the processor tests each visible point for casters between it
/// and the light. The result is as exact as with volumes, and nothing is filled (docs/method.md,
/// C46).
class IrregularShadowPass {
  public:
    explicit IrregularShadowPass(const gl::Capabilities& capabilities);

    /// Call when the framebuffer shows other surfaces.
    void forgetSurfaces() { known_ = false; }

    /// Marks the light's shadow on a slice's surfaces in the current framebuffer: the stencil,
    /// which must be 0, is not 0 there. The colour and depth masks, the viewport (the picture's)
    /// and the scissor (`reach`) are the caller's state. `area`: contains `reach`, and is the same
    /// for every light of the slice. Leaves the depth test and the stencil test on. Throws
    /// Error(unavailable) if the GL can't find the triangle of each pixel. `animatedAlone`: other
    /// casters are in a lookup.
    void mark(const GpuScene& scene, const FrameView& view, const DepthSlice& slice,
              const Light& light, const PixelRectangle& reach, const PixelRectangle& area,
              bool animatedAlone);

    /// Memory on the GPU.
    std::size_t bytes() const {
        return static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y) +
               numbers_.bytes();
    }

  private:
    /// The casters of a geometry, kept as long as any batch has it.
    struct Kept {
        CopyOnWrite<Geometry> geometry; ///< shared, so that nobody edits it in place
        std::shared_ptr<const int> scene;
        CasterRuns casters{};
        bool used = true;
    };
    std::vector<PlacedRuns> castersOf(const GpuScene& scene, bool animatedAlone);
    void upload(const std::vector<std::uint8_t>& marked);

    SurfaceNumbers numbers_;
    WholePicture picture_;
    gl::Texture texture_;
    glm::ivec2 size_{0}; ///< size of the texture
    SeenTriangles seen_;
    bool known_ = false; ///< `seen_` matches the framebuffer
    std::map<const Geometry*, Kept> kept_;
};

} // namespace edgeshade
