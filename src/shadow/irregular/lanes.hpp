#pragma once

#include <cstddef>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace edgeshade {

/// Four floats for SIMD operations, where the processor has them.
using Lanes = float __attribute__((vector_size(16)));
/// Result of comparisons: all bits of a lane set if true, otherwise none.
using LaneMask = int __attribute__((vector_size(16)));

inline constexpr std::size_t laneCount = 4;

/// One bit for each true lane, the first one lowest.
inline unsigned bitsOf(LaneMask mask) {
#ifdef __SSE2__
    return static_cast<unsigned>(_mm_movemask_ps(reinterpret_cast<__m128>(mask)));
#else
    const LaneMask bits = mask & LaneMask{1, 2, 4, 8};
    return static_cast<unsigned>(bits[0] | bits[1] | bits[2] | bits[3]);
#endif
}

} // namespace edgeshade
