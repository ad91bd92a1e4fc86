#pragma once

#include "preprocess/base/file_io.hpp"
#include "src/hours/surfaces/surface_run.hpp"

namespace edgeshade::hours {

/// The most bytes of bits that a file holds.
inline constexpr std::size_t mostBytesOfBits = std::size_t{4} << 30;

/// The bits of a run as a NumPy array (format 1.0): cells by packed positions, bytes in rows.
/// numpy.unpackbits(array, axis=1, count=positions) makes an array of 0 and 1. `run`: has bits.
Bytes npyOf(const SurfaceRun& run);

} // namespace edgeshade::hours
