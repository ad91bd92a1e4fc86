#pragma once

#include <array>
#include <cstddef>

namespace edgeshade {

/// 4x4 matrix, column-major as in GL.
using Matrix16 = std::array<double, 16>;
inline constexpr Matrix16 identity16 = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

} // namespace edgeshade
