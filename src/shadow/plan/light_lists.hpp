#pragma once

#include "src/shadow/geometry/pixel_rectangle.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace edgeshade {

/// A light without a shadow, and the pixels that it reaches in a depth slice.
struct ReachingLight {
    std::size_t light = 0; ///< index in the view
    PixelRectangle reach;  ///< LightPlan::reach
};

/// The lights that may reach each tile of a picture. One pass over the surfaces adds them up.
struct LightLists {
    static constexpr int tile = 32; ///< edge of a tile in pixels

    struct Range {
        std::uint32_t first = 0, count = 0; ///< in `entries`
    };
    int columns = 0;
    std::vector<std::size_t> lights;    ///< lights that are in some list, in the given order:
                                        ///< indices in the view
    std::vector<Range> ofTile;          ///< row by row from the picture's lower left corner
    std::vector<std::uint32_t> entries; ///< indices into `lights`, ascending in each list
    std::size_t longest = 0;
    PixelRectangle reach; ///< bounds of all lights' pixels
};

/// Lists lights by tile in a picture of `width` by `height` pixels. Takes time linear in the number
/// of entries.
LightLists listLights(std::span<const ReachingLight> lights, int width, int height);

} // namespace edgeshade
