#pragma once

namespace edgeshade::gl {

/// Reduces the bound picture's depth precision to `wanted` bits: the depth range restricts a
/// fixed-point buffer of `bits` bits to its lowest 2^wanted values. Does nothing if the buffer has
/// no more than `wanted` bits.
void coarsenDepth(int bits, int wanted);

} // namespace edgeshade::gl
