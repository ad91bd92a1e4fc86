#pragma once

#include "src/plot/canvas.hpp"

#include <optional>
#include <string>
#include <vector>

namespace edgeshade::plot {

/// A picture of hours of sunlight, with its colour scale.
struct HoursSheet {
    std::string title;
    std::vector<std::string> subtitles; ///< one line each
    int width = 1;                      ///< of the picture, in pixels
    int height = 1;
    std::vector<std::uint8_t> rgba;  ///< the picture, rows top to bottom
    double most = 1.0;               ///< hours at the upper end of the scale, above 0
    std::optional<double> threshold; ///< marked on the scale
};

/// Draws the sheet as a PNG that shows every pixel of the picture as one of its own. Throws
/// Error(unavailable) if the program was built without cairo.
Bytes hoursPng(const HoursSheet& sheet);

/// Round values from 0 to `most`, at most seven of them.
std::vector<double> scaleTicks(double most);

} // namespace edgeshade::plot
