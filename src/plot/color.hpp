#pragma once

#include <cstdint>

namespace edgeshade::plot {

/// 0xRRGGBB.
using Color = std::uint32_t;

} // namespace edgeshade::plot
