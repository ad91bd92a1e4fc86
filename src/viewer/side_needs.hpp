#pragma once

#include "src/viewer/view_state.hpp"

namespace edgeshade::viewer {

inline bool looksUp(const SideSettings& side) {
    return side.shadows == ShadowMethod::automatic || side.shadows == ShadowMethod::primitiveMap;
}

/// Whether shadow volumes may be needed for a side.
inline bool mayCount(const SideSettings& side) {
    return side.shadows == ShadowMethod::volumes || looksUp(side);
}

/// Whether volumes of a side, if any, are drawn from plane-pair records.
inline bool takesPlanePairs(const SideSettings& side) {
    return !mayCount(side) || volumeLayoutOf(side.multiplicity) == VolumeLayout::planePairs;
}

/// The same of all sides that the state shows.
inline bool takesPlanePairs(const ViewState& state) {
    return takesPlanePairs(state.left) && (!state.split || takesPlanePairs(state.right));
}

/// Settings for counting hours of sunlight, the same as those of `edgeshade sunhours`.
inline constexpr SideSettings hoursSide{ShadowMethod::volumes};

} // namespace edgeshade::viewer
