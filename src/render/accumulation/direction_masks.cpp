#include "src/render/accumulation/direction_masks.hpp"

#include "src/shadow/layers/layer_search.hpp"

namespace edgeshade {

FrameView directionMasks(const FrameView& seen, const LoadedScene& loaded,
                         std::span<const glm::dvec3> directions) {
    FrameView view = seen;
    view.lights.clear();
    LayerSearch search;
    for (const glm::dvec3& direction : directions) {
        FrameLight& of = view.lights.emplace_back();
        of.light.position = glm::dvec4(direction, 0.0);
        of.layers = search.bound(loaded.layerCasters(), of.light, stencilLimit, seen.visible);
    }
    view.drawBlended = false;
    view.mask = true;
    view.sumsMasks = true;
    return view;
}

} // namespace edgeshade
