#pragma once

#include <cstdint>
#include <limits>
#include <vector>

namespace edgeshade {

/// Which triangles of a cut geometry are triangles of the geometry before, and which ones planes
/// met.
struct CutOrigins {
    static constexpr std::uint32_t piece = std::numeric_limits<std::uint32_t>::max();

    /// For each triangle of the cut geometry, its number in the geometry before; `piece`: of a
    /// triangle that a plane met, or of a fill. Empty: the geometry was cut as a whole or not at
    /// all.
    std::vector<std::uint32_t> ofTriangle;
    std::vector<std::uint32_t> met; ///< triangles of the geometry before, ascending
};

} // namespace edgeshade
