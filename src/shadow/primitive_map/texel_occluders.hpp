#pragma once

#include "src/shadow/primitive_map/footprint.hpp"
#include "src/shadow/primitive_map/tile_spread.hpp"

#include <span>
#include <vector>

namespace edgeshade {

/// The footprints of one tile, with what they are of.
struct TileFootprints {
    std::span<const Occluder> occluders;
    std::span<const Footprint> prints;
    bool directional = true;
    TileSpread spread;
};

/// A footprint in a list, with the depth before which it holds nothing there.
struct ListedOccluder {
    std::uint32_t print = 0;
    double nearest = 0.0;
};

/// What shades a texel's rays (docs/method.md, C34); of a light with an extent, what is between its
/// points and any of the light's places (C42).
struct TexelOccluders {
    /// Every ray of the texel is blocked behind this depth; infinite: nothing says so.
    double darkBehind = std::numeric_limits<double>::infinity();
    /// Together with these all that blocks its rays, from near to far: for points on light-facing
    /// casters the first `forCasters`, for others all. What is alpha-tested is there wherever it
    /// isn't wholly behind darkBehind, and then for all alike.
    std::vector<ListedOccluder> listed;
    std::size_t forCasters = 0;
    /// All that touches the texel and isn't wholly behind darkBehind: candidates of its parts.
    std::vector<std::uint32_t> touching;
};

/// Finds them among candidates, of which none that may touch the square is missing. `square`: the
/// texel, grown by what rounding may place into it. `othersReceive`: some surfaces are no casters,
/// or not those that cast. The result's vectors are written over.
void findOccluders(const TileFootprints& tile, std::span<const std::uint32_t> candidates,
                   const RaySquare& square, bool othersReceive, TexelOccluders& result);

} // namespace edgeshade
