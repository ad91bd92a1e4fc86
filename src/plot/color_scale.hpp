#pragma once

#include "src/plot/color.hpp"

namespace edgeshade::plot {

/// The colour of a share from 0, dark blue, via grey red, to 1, light yellow. It is even in OKLab
/// (Ottosson 2020): lightness and blue to yellow grow with the share alike. It therefore reads the
/// same without red-green vision, and in grey. Shares are clamped to 0..1.
Color evenColor(double share);

} // namespace edgeshade::plot
