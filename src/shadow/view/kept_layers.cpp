#include "src/shadow/view/kept_layers.hpp"

#include <algorithm>

namespace edgeshade {

bool KeptLayers::Kept::holdsFor(const Box& visible) const {
    return receivers.empty() ||
           (!visible.empty() && receivers.holds(visible.low) && receivers.holds(visible.high));
}

bool KeptLayers::fill(const LayerCasters& casters, std::vector<FrameLight>& lights,
                      const Box& visible) {
    next_.clear();
    bool anyNew = false;
    for (FrameLight& of : lights) {
        if (!of.shadowed || of.animatedAlone) continue;
        const auto found = std::find_if(kept_.begin(), kept_.end(), [&](const Kept& known) {
            return known.light == of.light.position && known.range == of.light.range &&
                   known.extent == of.light.extent && known.points == of.points.size();
        });
        const bool rests = found != kept_.end();
        if (!of.drawn && !rests) continue; // not needed until it is drawn
        if (rests && found->holdsFor(visible)) {
            of.layers = found->layers;
            next_.push_back(*found);
            continue;
        }
        anyNew = true;
        const Box receivers = rests ? Box() : visible;
        of.layers = search_.bound(casters, of.counted(), stencilLimit, receivers);
        next_.push_back({of.light.position, of.light.range, of.light.extent, of.points.size(),
                         receivers, of.layers});
    }
    kept_.swap(next_);
    return anyNew;
}

} // namespace edgeshade
