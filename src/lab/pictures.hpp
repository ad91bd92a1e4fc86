#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace edgeshade::lab {

/// One view's pictures, RGBA rows top to bottom, all of the question's size.
struct Pictures {
    std::vector<std::uint8_t> mask;  ///< the program's lit mask of light 0
    std::vector<std::uint8_t> image; ///< the program's picture
    /// The program's picture without shadows, with those lights alone whose bits are set: what the
    /// oracle's picture takes each pixel from, whatever the surfaces are shaded with.
    std::function<std::vector<std::uint8_t>(std::uint32_t lights)> unshadowed;
};

} // namespace edgeshade::lab
