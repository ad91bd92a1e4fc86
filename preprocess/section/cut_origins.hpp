#pragma once

#include <cstdint>
#include <limits>
#include <vector>

namespace edgeshade {

/// Which triangles of a cut geometry are triangles of the geometry before, and which ones planes
/// met.
struct CutOrigins {
    /// Added to the number of a triangle that planes met: this is a piece of it, or all of it.
    static constexpr std::uint32_t piece = std::uint32_t{1} << 31;
    static constexpr std::uint32_t fill = std::numeric_limits<std::uint32_t>::max();

    /// For each triangle of the cut geometry, its number in the geometry before, perhaps with
    /// `piece`; or `fill`. Empty: the geometry is the one before, or that of an earlier cut.
    std::vector<std::uint32_t> ofTriangle;
    std::vector<std::uint32_t> met; ///< triangles of the geometry before, ascending

    /// Keeps the memory, since most cuts follow others like them.
    void clear() {
        ofTriangle.clear();
        met.clear();
    }
};

} // namespace edgeshade
