#include "src/render/volumes/volume_counter.hpp"

#include "src/render/volumes/stencil_count.hpp"

#include <GLES2/gl2.h>
#include <optional>

namespace edgeshade {
namespace {

/// Moves culled casters' caps away from the eye, for as long as it lives: behind a surface that they
/// coincide with, as the point that is asked for lies before it (docs/method.md, C39).
class CulledCapOffset {
  public:
    CulledCapOffset() {
        glEnable(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(slopes, units);
    }
    ~CulledCapOffset() {
        glPolygonOffset(0.0f, 0.0f);
        glDisable(GL_POLYGON_OFFSET_FILL);
    }
    CulledCapOffset(const CulledCapOffset&) = delete;
    CulledCapOffset& operator=(const CulledCapOffset&) = delete;

  private:
    static constexpr float slopes = 0.0625f; ///< of a pixel: the coarsest grid of GLES 2
    static constexpr float units = 2.0f;     ///< of the depth buffer
};

} // namespace

void VolumeCounter::count(const CountPlan& plan, const VolumeRenderer& volumes,
                          const GpuScene& scene, const CasterGroupInSlice& casters) const {
    const auto drawAll = [&](const std::vector<VolumeDraw>& draws) {
        forEachDraw(draws, plan, volumes, scene, casters,
                    [&](const VolumeDraw& draw, const DrawnBatch& batch) {
                        countByOne(draw.zFail, batch.mirrored);
                        std::optional<CulledCapOffset> offset;
                        if (draw.culled) offset.emplace();
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
