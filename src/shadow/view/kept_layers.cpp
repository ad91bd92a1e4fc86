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
    bool allKnown = true;
    for (FrameLight& of : lights)
        if (of.shadowed && !of.animatedAlone) allKnown = fillOne(casters, of, visible) && allKnown;
    kept_.swap(next_);
    return !allKnown;
}

bool KeptLayers::fillMovers(const LayerCasters& casters, FrameLight& light, const Box& visible) {
    next_.clear();
    const bool known = fillOne(casters, light, visible);
    kept_.swap(next_);
    return !known;
}

bool KeptLayers::lookAhead(const LayerCasters& casters, const FrameLight& light,
                           const Box& visible) {
    const std::optional<Box> receivers = unknownFor(light, keptOf(light), visible);
    if (!light.shadowed || !receivers) return true;
    return search_.lookAhead(casters, light.counted().front(), stencilLimit, *receivers);
}

std::optional<Box> KeptLayers::unknownFor(const FrameLight& light,
                                          std::vector<Kept>::const_iterator found,
                                          const Box& visible) const {
    if (found != kept_.end()) return found->holdsFor(visible) ? std::nullopt : std::optional(Box());
    // Not needed until it is drawn.
    return light.drawn ? std::optional(visible) : std::nullopt;
}

auto KeptLayers::keptOf(const FrameLight& light) const -> std::vector<Kept>::const_iterator {
    return std::find_if(kept_.begin(), kept_.end(), [&](const Kept& known) {
        return known.light == light.light.position && known.range == light.light.range &&
               known.extent == light.light.extent && known.points == light.points.size();
    });
}

bool KeptLayers::fillOne(const LayerCasters& casters, FrameLight& of, const Box& visible) {
    const auto found = keptOf(of);
    const std::optional<Box> receivers = unknownFor(of, found, visible);
    if (!receivers) {
        if (found == kept_.end()) return true;
        of.layers = found->layers;
        next_.push_back(*found);
        return true;
    }
    of.layers = search_.bound(casters, of.counted(), stencilLimit, *receivers);
    next_.push_back({of.light.position, of.light.range, of.light.extent, of.points.size(),
                     *receivers, of.layers});
    return false;
}

} // namespace edgeshade
