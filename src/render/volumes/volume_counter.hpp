#pragma once

#include "src/gl/capabilities.hpp"
#include "src/render/drawing/batch_view.hpp"
#include "src/render/drawing/whole_picture.hpp"
#include "src/render/volumes/volume_renderer.hpp"

namespace edgeshade {

/// Counts in the stencil, modulo 256, how many shadow volumes contain each surface in the depth
/// buffer: 0 where the surface is lit. The plan decides what is drawn, and in which order.
class VolumeCounter {
  public:
    explicit VolumeCounter(const gl::Capabilities& capabilities);

    /// Counts in a stencil that was cleared to plan.start. `volumes` must have prepared the plan.
    /// Colour and depth masks, the depth test and its function (less) and the stencil's test and
    /// function (always) are the caller's state.
    void count(const CountPlan& plan, const VolumeRenderer& volumes, const GpuScene& scene,
               const CasterGroupInSlice& casters) const;

    void forEachProgram(const gl::ProgramVisitor& visit) const { picture_.forEachProgram(visit); }

  private:
    WholePicture picture_;
    // How far caps of culled casters are moved away: by the change of depth over one step of the
    // vertex grid, and by rounding, in units of the depth buffer.
    float offsetSlopes_, offsetUnits_;
};

/// Calls use(draw, batch) for some draws of a plan, in order.
template <class Use>
void forEachDraw(const std::vector<VolumeDraw>& draws, const CountPlan& plan,
                 const VolumeRenderer& volumes, const GpuScene& scene,
                 const CasterGroupInSlice& casters, Use use) {
    std::optional<DrawnBatch> batch;
    for (const VolumeDraw& draw : draws) {
        const BatchPlan& of = plan.batches[draw.batch];
        if (!batch || &batch->plan != &of) {
            const BatchView seen =
                batchViewOf(scene.batches[of.batch], casters.view, casters.slice);
            batch.emplace(DrawnBatch{
                &scene,
                scene.volumesOf(of.batch, casters.source(), volumes.layout(), casters.group), of,
                seen.clipFromObject, seen.mirrored});
        }
        use(draw, *batch);
    }
}

} // namespace edgeshade
