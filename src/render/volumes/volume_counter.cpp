#include "src/render/volumes/volume_counter.hpp"

#include "src/render/volumes/stencil_count.hpp"

namespace edgeshade {

void VolumeCounter::count(const CountPlan& plan, const VolumeRenderer& volumes,
                          const GpuScene& scene, const CasterGroupInSlice& casters) const {
    const auto drawAll = [&](const std::vector<VolumeDraw>& draws) {
        forEachDraw(draws, plan, volumes, scene, casters,
                    [&](const VolumeDraw& draw, const DrawnBatch& batch) {
                        countByOne(draw.zFail, batch.mirrored);
                        volumes.draw(draw, batch);
                    });
    };
    if (!plan.draws.twice.empty()) {
        drawAll(plan.draws.twice);
        doubleCounts(plan.start, picture_);
    }
    drawAll(plan.draws.once);
}

} // namespace edgeshade
