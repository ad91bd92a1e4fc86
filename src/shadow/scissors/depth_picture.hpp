#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace edgeshade {

/// What a rectangle of a depth buffer holds.
struct DepthPicture {
    int width = 0, height = 0;
    int bits = 24; ///< of the buffer
    /// Rows from below; 0 to 2^32 - 1 for depths from 0 to 1, where nothing was drawn.
    std::vector<std::uint32_t> depths;
    int x = 0, y = 0; ///< of its lower left pixel

    const std::uint32_t& at(int column, int row) const {
        return depths[static_cast<std::size_t>(row - y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(column - x)];
    }
};

} // namespace edgeshade
