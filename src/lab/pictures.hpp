#pragma once

#include "src/shadow/geometry/frame_view.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace edgeshade::lab {

/// One view's pictures, RGBA rows top to bottom, all of the question's size.
struct Pictures {
    std::vector<std::uint8_t> mask;  ///< the program's lit mask of light 0
    std::vector<std::uint8_t> image; ///< the program's picture
    /// The picture with no light, with the first, and with the first and each other, all without
    /// shadows: what the oracle's picture is put together from, rounded as the program does, which
    /// draws the first light with ambient light.
    std::vector<std::uint8_t> ambient;
    std::vector<std::vector<std::uint8_t>> unshadowed;

    /// Takes these last from `draw`, which draws the frame without shadows.
    void drawUnshadowed(FrameView frame,
                        const std::function<std::vector<std::uint8_t>(const FrameView&)>& draw);
};

} // namespace edgeshade::lab
