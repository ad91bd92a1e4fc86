#include "src/render/accumulation/extended_lights.hpp"

#include <algorithm>

namespace edgeshade {

std::size_t ExtendedLights::points(const FrameView& view) {
    std::size_t most = 0;
    for (const FrameLight& of : view.lights)
        if (of.drawn) most = std::max(most, of.points.size());
    return most;
}

void ExtendedLights::advance(Renderer& renderer, GpuScene& scene, const LoadedScene& loaded,
                             const FrameView& view, std::size_t most, StageClock* clock) {
    std::size_t end = counted_;
    for (std::size_t i = 0; i < view.lights.size(); ++i) {
        const FrameLight& of = view.lights[i];
        if (of.points.empty() || !of.drawn) continue;
        LitCounter& counter = counters_.try_emplace(i, capabilities_).first->second;
        if (counted_ == 0) counter.begin(view.width, view.height);
        const std::size_t to = std::min(of.points.size(), counted_ + most);
        if (to > counted_)
            counter.addPoints(renderer, scene, loaded, view, i, counted_, to - counted_,
                              view.lights, clock);
        end = std::max(end, to);
    }
    counted_ = end;
}

std::vector<VisibilityLookup> ExtendedLights::visibility(const FrameView& view) {
    std::vector<VisibilityLookup> lookups(view.lights.size());
    for (std::size_t i = 0; i < lookups.size(); ++i)
        if (!view.lights[i].points.empty() && view.lights[i].drawn && counted_ > 0)
            lookups[i] = counters_.at(i).visibility();
    return lookups;
}

std::size_t ExtendedLights::bytes() const {
    std::size_t total = 0;
    for (const auto& [light, counter] : counters_)
        total += counter.bytes();
    return total;
}

void drawWithExtents(Renderer& renderer, ExtendedLights& lights, GpuScene& scene,
                     const LoadedScene& loaded, const FrameView& view, StageClock* clock) {
    lights.restart();
    lights.advance(renderer, scene, loaded, view, ExtendedLights::points(view), clock);
    renderer.draw(scene, view, clock, lights.visibility(view));
}

} // namespace edgeshade
