#include "src/shadow/view/kept_layers.hpp"

#include <algorithm>

namespace edgeshade {

bool KeptLayers::fill(const LayerCasters& casters, std::vector<FrameLight>& lights) {
    std::vector<Kept> kept;
    bool anyNew = false;
    for (FrameLight& of : lights) {
        if (!of.shadowed) continue;
        const auto found = std::find_if(kept_.begin(), kept_.end(), [&](const Kept& known) {
            return known.light == of.light.position && known.range == of.light.range &&
                   known.extent == of.light.extent && known.points == of.points.size();
        });
        const bool known = found != kept_.end();
        if (!of.drawn && !known) continue; // not needed until it is drawn
        anyNew = anyNew || !known;
        of.layers = known ? found->layers : search_.bound(casters, of.counted(), stencilLimit);
        kept.push_back(
            {of.light.position, of.light.range, of.light.extent, of.points.size(), of.layers});
    }
    kept_ = std::move(kept);
    return anyNew;
}

} // namespace edgeshade
