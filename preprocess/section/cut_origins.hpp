#pragma once

#include "preprocess/scene/scene.hpp"

#include <cstdint>
#include <limits>
#include <vector>

namespace edgeshade {

/// Origins of a cut geometry's triangles: triangles of the geometry before, pieces and fills.
struct CutOrigins {
    /// Added to the number of a triangle that planes met: this is a piece of it, or all of it.
    static constexpr std::uint32_t piece = std::uint32_t{1} << 31;
    static constexpr std::uint32_t fill = std::numeric_limits<std::uint32_t>::max();

    CopyOnWrite<Geometry> from; ///< the geometry before
    /// For each triangle of the cut geometry, its number in the geometry before, perhaps with
    /// `piece`; or `fill`.
    std::vector<std::uint32_t> ofTriangle;
    std::vector<std::uint32_t> met; ///< triangles of the geometry before, ascending
};

} // namespace edgeshade
