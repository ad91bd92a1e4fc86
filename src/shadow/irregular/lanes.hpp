#pragma once

#include <cstddef>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace edgeshade {

/// Four floats that are worked on at once, where the processor can.
using Lanes = float __attribute__((vector_size(16)));
/// What comparing them gives: all bits of a lane where it is true, else none.
using LaneMask = int __attribute__((vector_size(16)));

inline constexpr std::size_t laneCount = 4;

/// A bit for each lane that is true, the first lowest.
inline unsigned bitsOf(LaneMask mask) {
#ifdef __SSE2__
    return static_cast<unsigned>(_mm_movemask_ps(reinterpret_cast<__m128>(mask)));
#else
    const LaneMask bits = mask & LaneMask{1, 2, 4, 8};
    return static_cast<unsigned>(bits[0] | bits[1] | bits[2] | bits[3]);
#endif
}

} // namespace edgeshade
