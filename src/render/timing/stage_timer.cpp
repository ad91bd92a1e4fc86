#include "src/render/timing/stage_timer.hpp"

#include <algorithm>

namespace edgeshade {

StageMs stageMs(std::span<const gl::SpanTimer::Span> frame) {
    StageMs sum;
    double volumes = 0.0;
    for (const auto& span : frame) {
        switch (static_cast<FrameStage>(span.label)) {
        case FrameStage::ambient:
            sum.ambient += span.milliseconds;
            break;
        case FrameStage::map:
            sum.map += span.milliseconds;
            break;
        case FrameStage::silhouette:
            sum.silhouette += span.milliseconds;
            break;
        case FrameStage::counting:
            volumes += span.milliseconds;
            break;
        case FrameStage::lit:
            sum.lit += span.milliseconds;
            break;
        }
    }
    sum.rasterise = std::max(0.0, volumes - sum.silhouette);
    return sum;
}

} // namespace edgeshade
