#include "src/render/shadow_map/map_technique.hpp"

#include "src/scene/build_parts.hpp"

#include <algorithm>

namespace edgeshade {

MapTechnique::MapTechnique(const ShadowMapSettings& settings, const gl::Capabilities& capabilities)
    : settings_(settings), pass_(settings, capabilities) {
    if (settings.kind == MapKind::warped) places_.emplace(capabilities);
}

void MapTechnique::beginFrame(const FrameStart& start) {
    drawn_.reset();
    if constexpr (allMapKinds) {
        const auto isWarped = [&](const FrameLight& of) {
            return of.drawn && mapKindOf(of.light, settings_) == ShadowMapKind::warped;
        };
        const std::vector<FrameLight>& lights = start.view.lights;
        if (!places_ || std::none_of(lights.begin(), lights.end(), isWarped)) return;
        const StageScope stage(start.clock, FrameStage::map);
        visible_ = places_->find(start.view, start.drawNearness);
    }
}

std::size_t MapTechnique::draw(const GpuScene& scene, const FrameView& view, const Light& light) {
    drawn_ = pass_.draw(scene, view, light, visible_);
    return pass_.vertexRuns();
}

} // namespace edgeshade
