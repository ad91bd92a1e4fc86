#pragma once

#include "src/render/frame/surface_pass.hpp"
#include "src/render/volumes/adapted_volumes.hpp"
#include "src/render/volumes/published/caps_pass.hpp"
#include "src/render/volumes/published/sides_pass.hpp"
#include "src/shadow/geometry/frame_view.hpp"

namespace edgeshade {

/// A debug view: tints the picture by what is drawn of one light's shadow volumes. Sides where they
/// stand in front of what is visible: orange, of volumes that are counted behind surfaces and so
/// have caps red, and green over these the second quad where the multiplicity is 2. Caps blue
/// wherever they are drawn (all of them lie at infinity). Published volumes are orange and blue.
class VolumeTintPass {
  public:
    /// `instancing` must be there unless the layout is notInstanced.
    VolumeTintPass(MultiplicityMethod method, SidesLayout layout,
                   std::optional<gl::Instancing> instancing);

    /// Blends over the current framebuffer. Draws depth anew: of several depth slices only the
    /// nearest is left in the buffer.
    void draw(const GpuScene& scene, const FrameView& view, const Light& light);

  private:
    void drawAdapted(const GpuBatch& batch, const GpuScene& scene, const FrameView& view,
                     const DepthSlice& slice, const Light& light, const glm::mat4& clipFromObject);

    SurfacePass surfaces_;
    std::optional<AdaptedVolumes> adapted_; ///< where multiplicities come from planes
    std::optional<SidesPass> sides_;        ///< where not
    std::optional<CapsPass> caps_;          ///< likewise
};

} // namespace edgeshade
