#pragma once

#include "src/render/frame/surface_pass.hpp"
#include "src/render/frame/volume_renderers.hpp"
#include "src/shadow/plan/frame_plan.hpp"

namespace edgeshade {

/// A debug view: tints a frame's picture by what its plan drew of one light's shadow volumes,
/// within the pixels that the light reaches. Sides where they stand in front of what is visible:
/// orange, of volumes that are counted behind surfaces and so have caps red, and green those that
/// count twice. Caps, and the fans that stand for them, blue wherever they are drawn (all of them
/// lie at infinity). Of several depth slices each tints the surfaces that it holds, and the
/// farthest what is behind all.
class VolumeTintPass {
  public:
    /// `settings` as those of the renderer whose plans are shown; shadows must be volumes.
    VolumeTintPass(const RenderSettings& settings, const gl::Capabilities& capabilities);

    /// Blends over the current framebuffer, whose depth and stencil it draws anew. `plan`: of the
    /// frame that was drawn last.
    void draw(GpuScene& scene, const FrameView& view, const FramePlan& plan, std::size_t light);

    static const VolumeTints tints; ///< with their shares in alpha

  private:
    void drawSurfaces(const GpuScene& scene, const FrameView& view, const DepthSlice& slice);
    void tint(const std::vector<VolumeDraw>& draws, const CountPlan& plan, const GpuScene& scene,
              const CasterGroupInSlice& casters) const;

    SurfacePass surfaces_;
    std::unique_ptr<VolumeRenderer> volumes_;
};

} // namespace edgeshade
