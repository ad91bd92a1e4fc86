#include "src/viewer/convergence.hpp"

#include "src/render/frame/prepare_scene.hpp"

#include <algorithm>

namespace edgeshade::viewer {

void Convergence::see(const CountedScene& scene, const FrameView& view) {
    if (view_ && scene == scene_) return;
    scene_ = scene;
    view_ = view;
    counted_ = shown_ = of_ = 0;
    pace_.restart();
    for (std::size_t i = 0; i < view_->lights.size(); ++i) {
        FrameLight& of = view_->lights[i];
        if (of.light.extent && scene.drawn[i]) {
            of.points = lightPoints(of.light, scene.lightSamples);
            of_ = scene.lightSamples;
        }
    }
    for (ExtendedLights& side : sides_)
        side.restart();
}

bool Convergence::advance(std::array<Renderer*, 2> renderers, GpuScene& scene,
                          const LoadedScene& loaded, double now) {
    const std::size_t picture = nextPicture(counted_, of_);
    const std::size_t masks = pace_.next(now);
    const bool byMap = std::all_of(renderers.begin(), renderers.end(), [&](const Renderer* of) {
        return !of || areCountedByMaps(*of, scene);
    });
    const std::size_t end = std::min(counted_ + (byMap ? placesAtOnce : 1) * masks, picture);
    for (FrameLight& of : view_->lights) {
        if (of.points.empty() || byMap) continue;
        const std::span<const Light> next(of.points.data() + counted_, end - counted_);
        of.layers = layers_.bound(loaded.layerCasters(), next, stencilLimit);
        if (of.layers.groupCount > 1) scene.groups.clear(); // other points need other groups
    }
    for (std::size_t side = 0; side < sides_.size(); ++side) {
        counts_[side] = renderers[side] != nullptr;
        if (renderers[side])
            sides_[side].advance(*renderers[side], scene, loaded, *view_, end - counted_);
    }
    counted_ = end;
    if (counted_ < picture) return false;
    shown_ = counted_;
    return true;
}

bool Convergence::areCountedByMaps(const Renderer& renderer, const GpuScene& scene) const {
    return renderer.settings().looksUpPrimitives() &&
           std::all_of(view_->lights.begin(), view_->lights.end(), [&](const FrameLight& of) {
               return of.points.empty() || extendedMapOf(scene, of.light) != nullptr;
           });
}

std::vector<VisibilityLookup> Convergence::visibility(std::size_t side) {
    if (shown_ == 0 || !counts_[side]) return {};
    return sides_[side].visibility(*view_);
}

} // namespace edgeshade::viewer
