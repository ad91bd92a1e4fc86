#pragma once

#include "src/lab/verdicts.hpp"

namespace edgeshade::lab {

/// The picture in grey with wrong pixels in colour: red wrongly lit, blue wrongly dark, green
/// otherwise wrong, yellow ties. Each has a faint square around it, so that single pixels are
/// visible. RGBA rows top to bottom.
std::vector<std::uint8_t> heatmap(const std::vector<std::uint8_t>& image,
                                  const std::vector<PixelKind>& kinds, int width, int height);

} // namespace edgeshade::lab
