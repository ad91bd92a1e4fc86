#pragma once

#include "src/scene/load.hpp"
#include "src/shadow/view/kept_layers.hpp"
#include "src/shadow/view/light_budget.hpp"

namespace edgeshade::lab {

/// The frame in which a comparison draws a scene: all but BLEND surfaces, which the oracle leaves
/// out. `mostShadowed`: see chooseLights().
inline FrameView comparedFrame(const LoadedScene& loaded, const FrameRequest& request,
                               std::optional<std::size_t> mostShadowed = {}) {
    FrameView frame = makeFrameView(loaded.scene, request, worldBounds(loaded.scene));
    chooseLights(frame, mostShadowed);
    KeptLayers().fill(loaded.layerCasters(), frame.lights, frame.visible);
    frame.drawBlended = false;
    return frame;
}

} // namespace edgeshade::lab
