#include "src/render/volumes/volume_counter.hpp"

#include "src/render/volumes/stencil_count.hpp"

#include <cmath>
#include <GLES2/gl2.h>
#include <optional>

namespace edgeshade {
namespace {

/// Moves caps of culled casters away from the eye, for its lifetime. They lie behind a surface that
/// they coincide with, as the counted point lies before it (docs/method.md, C39).
class CulledCapOffset {
  public:
    CulledCapOffset(float slopes, float units) {
        glEnable(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(slopes, units);
    }
    ~CulledCapOffset() {
        glPolygonOffset(0.0f, 0.0f);
        glDisable(GL_POLYGON_OFFSET_FILL);
    }
    CulledCapOffset(const CulledCapOffset&) = delete;
    CulledCapOffset& operator=(const CulledCapOffset&) = delete;
};

/// Counts all drawn pixels by one, with or without surfaces, for its lifetime.
class CountAll {
  public:
    CountAll() {
        glDisable(GL_DEPTH_TEST);
        glStencilOp(GL_KEEP, GL_KEEP, GL_INCR_WRAP);
    }
    ~CountAll() { glEnable(GL_DEPTH_TEST); }
    CountAll(const CountAll&) = delete;
    CountAll& operator=(const CountAll&) = delete;
};

/// Rounding of a depth in a rasteriser's floats: 2 to this power.
constexpr int depthRoundingBits = -23;

} // namespace

VolumeCounter::VolumeCounter(const gl::Capabilities& capabilities)
    : offsetSlopes_(std::ldexp(1.0f, -capabilities.subpixelBits)),
      offsetUnits_(std::ldexp(1.0f, capabilities.depthBits + depthRoundingBits)) {}

void VolumeCounter::count(const CountPlan& plan, const VolumeRenderer& volumes,
                          const GpuScene& scene, const CasterGroupInSlice& casters) const {
    const auto drawAll = [&](const std::vector<VolumeDraw>& draws) {
        forEachDraw(draws, plan, volumes, scene, casters,
                    [&](const VolumeDraw& draw, const DrawnBatch& batch) {
                        const bool negative = draw.shape == VolumeDraw::Shape::negativeSides;
                        countByOne(draw.zFail, batch.mirrored != negative);
                        std::optional<CulledCapOffset> offset;
                        if (draw.culled) offset.emplace(offsetSlopes_, offsetUnits_);
                        std::optional<CountAll> all;
                        if (draw.shape == VolumeDraw::Shape::nearCaps) all.emplace();
                        volumes.draw(draw, batch);
                    });
    };
    if (plan.start.isDoubled()) {
        drawAll(plan.draws.twice);
        doubleCounts(plan.start, picture_);
    }
    drawAll(plan.draws.once);
}

} // namespace edgeshade
