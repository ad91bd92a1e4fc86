#pragma once

#include "src/shadow/primitive_map/footprint.hpp"
#include "src/shadow/primitive_map/tile_spread.hpp"

#include <span>
#include <vector>

namespace edgeshade {

/// The footprints of one tile, with their occluders.
struct TileFootprints {
    std::span<const Occluder> occluders;
    std::span<const Footprint> prints;
    bool directional = true;
    TileSpread spread;
};

/// A footprint in a list, and the nearest depth of its points there.
struct ListedOccluder {
    std::uint32_t print = 0;
    double nearest = 0.0;
};

/// The occluders of a texel's rays (docs/method.md, C34). For a light with an extent, those between
/// the texel's points and any point of the light (C42).
struct TexelOccluders {
    /// Every ray of the texel is blocked behind this depth; infinite: unknown.
    double darkBehind = std::numeric_limits<double>::infinity();
    /// With darkBehind, everything that blocks its rays, from near to far. Points on light-facing
    /// casters need the first `forCasters` entries, other points all. Alpha-tested occluders are
    /// listed wherever they aren't wholly behind darkBehind, and then for all points.
    std::vector<ListedOccluder> listed;
    std::size_t forCasters = 0;
    /// All occluders that touch the texel and aren't wholly behind darkBehind: candidates for its
    /// pieces.
    std::vector<std::uint32_t> touching;
};

/// Finds a texel's occluders among candidates, which must include all that may touch the square.
/// `square`: the texel, grown by the rounding error of points. `othersReceive`: some surfaces don't
/// cast, or differ from the casters. Overwrites the result's vectors.
void findOccluders(const TileFootprints& tile, std::span<const std::uint32_t> candidates,
                   const RaySquare& square, bool othersReceive, TexelOccluders& result);

} // namespace edgeshade
