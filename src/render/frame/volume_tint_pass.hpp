#pragma once

#include "src/render/frame/surface_pass.hpp"
#include "src/render/frame/volume_renderers.hpp"
#include "src/shadow/plan/frame_plan.hpp"

namespace edgeshade {

/// A debug view that tints a frame's picture by the shadow volumes of one light that its plan drew,
/// within the pixels that the light reaches. Sides in front of visible surfaces are orange; sides
/// of volumes that are counted behind surfaces, and so have caps, are red; sides that count twice
/// are green. Caps and fans are blue wherever they are drawn, as all lie at infinity. With several
/// depth slices each tints its own surfaces, and the farthest also tints the background.
class VolumeTintPass {
  public:
    /// `settings`: those of the renderer whose plans are shown; shadows must be volumes.
    VolumeTintPass(const RenderSettings& settings, const gl::Capabilities& capabilities);

    /// Blends over the current framebuffer, and draws its depth and stencil again. `plan`: of the
    /// last frame drawn.
    void draw(GpuScene& scene, const FrameView& view, const FramePlan& plan, std::size_t light);

    static const VolumeTints tints; ///< alpha is the tint's share

  private:
    void drawSurfaces(const GpuScene& scene, const FrameView& view, const DepthSlice& slice);
    void tint(const std::vector<VolumeDraw>& draws, const CountPlan& plan, const GpuScene& scene,
              const CasterGroupInSlice& casters) const;

    SurfacePass surfaces_;
    std::unique_ptr<VolumeRenderer> volumes_;
};

} // namespace edgeshade
