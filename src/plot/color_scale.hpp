#pragma once

#include "src/plot/color.hpp"

namespace edgeshade::plot {

/// A colour for a share from 0, dark blue, by way of grey red, to 1, light yellow. Even in OKLab
/// (Ottosson 2020): lightness and blue to yellow grow alike with the share, so that it reads the
/// same to whoever can't tell red from green, and in grey. Shares beyond are taken for 0 and 1.
Color evenColor(double share);

} // namespace edgeshade::plot
