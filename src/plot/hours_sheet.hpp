#pragma once

#include "src/plot/canvas.hpp"

#include <optional>
#include <string>
#include <vector>

namespace edgeshade::plot {

/// A picture of hours of sun, with what its colours mean.
struct HoursSheet {
    std::string title;
    std::vector<std::string> subtitles; ///< a line each
    int width = 1;                      ///< of the picture, pixels
    int height = 1;
    std::vector<std::uint8_t> rgba;  ///< of the picture, rows top to bottom
    double most = 1.0;               ///< hours at the end of the scale, above 0
    std::optional<double> threshold; ///< marked on the scale
};

/// Draws the sheet as a PNG: every pixel of the picture is one of the sheet. Throws
/// Error(unavailable) where the program was built without cairo.
Bytes hoursPng(const HoursSheet& sheet);

/// Round values from 0 to `most`, at most seven.
std::vector<double> scaleTicks(double most);

} // namespace edgeshade::plot
