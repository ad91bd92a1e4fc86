#include "src/render/accumulation/direction_masks.hpp"

namespace edgeshade {

FrameView directionMasks(const FrameView& seen, const LoadedScene& loaded,
                         std::span<const glm::dvec3> directions) {
    FrameView view = seen;
    view.lights.clear();
    for (const glm::dvec3& direction : directions) {
        FrameLight& of = view.lights.emplace_back();
        of.light.position = glm::dvec4(direction, 0.0);
        of.layers = boundLayers(loaded.scene, loaded.settings.castMasked, of.light, stencilLimit);
    }
    view.drawBlended = false;
    view.mask = true;
    view.sumsMasks = true;
    return view;
}

} // namespace edgeshade
