#pragma once

#include "src/gl/capabilities.hpp"
#include "src/gl/objects.hpp"
#include "src/render/drawing/whole_picture.hpp"
#include "src/scene/gpu_scene.hpp"
#include "src/shadow/geometry/frame_view.hpp"
#include "src/shadow/geometry/pixel_rectangle.hpp"
#include "src/shadow/irregular/irregular_z_buffer.hpp"
#include "src/shadow/scissors/depth_picture.hpp"

#include <map>

namespace edgeshade {

/// Shadows by an IrregularZBuffer, which the processor asks of each visible point whether something
/// is between it and the light: exact as volumes are, and nothing is filled (docs/method.md, C46).
class IrregularShadowPass {
  public:
    /// Throws Error(unavailable) where depth buffers can't be read.
    explicit IrregularShadowPass(const gl::Capabilities& capabilities);

    /// Marks what of a slice's surfaces in the current framebuffer is in the light's shadow: the
    /// stencil, which must be 0, is not 0 there. Colour and depth masks are the caller's state, as
    /// are the viewport, the picture's, and the scissor, which is `reach`. Leaves the depth test
    /// on, the stencil's test on. Throws Error(unavailable) where the framebuffer's depth can't be
    /// read.
    void mark(const GpuScene& scene, const FrameView& view, const DepthSlice& slice,
              const Light& light, const PixelRectangle& reach);

  private:
    /// The casters of a geometry, as long as batches have it.
    struct Kept {
        CopyOnWrite<Geometry> geometry; ///< it is shared, so that nobody edits it in place
        std::shared_ptr<const int> scene;
        CasterRuns casters{};
        bool used = true;
    };
    std::vector<PlacedRuns> castersOf(const GpuScene& scene);
    void upload(int width, int height, const std::vector<std::uint8_t>& marked);

    int subpixelBits_;
    WholePicture picture_;
    gl::Texture texture_;
    glm::ivec2 size_{0}; ///< the texture's
    DepthPicture depths_;
    std::map<const Geometry*, Kept> kept_;
};

} // namespace edgeshade
