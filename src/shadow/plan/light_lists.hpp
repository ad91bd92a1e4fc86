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
    PixelRectangle reach;  ///< LightPlan's
};

/// Which lights may reach a picture's pixels, told for squares of them: what one pass over the
/// surfaces adds up.
struct LightLists {
    static constexpr int tile = 32; ///< pixels along a square's edge

    struct Range {
        std::uint32_t first = 0, count = 0; ///< of `entries`
    };
    int columns = 0;
    std::vector<std::size_t> lights;    ///< that are in some list, as given: indices in the view
    std::vector<Range> ofTile;          ///< row by row from the picture's lower left
    std::vector<std::uint32_t> entries; ///< indices of `lights`, ascending in each list
    std::size_t longest = 0;
    PixelRectangle reach; ///< around those of all lights
};

/// Lists lights by tile, in a picture of so many pixels. Takes time linear in the entries.
LightLists listLights(std::span<const ReachingLight> lights, int width, int height);

} // namespace edgeshade
