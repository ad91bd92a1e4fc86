#pragma once

namespace edgeshade::gl {

/// Makes the bound picture's depth as coarse as one of `wanted` bits: of a fixed-point buffer of
/// `bits` bits only the lowest 2^wanted values are used, by the depth range. Does nothing where it
/// has no more than `wanted`.
void coarsenDepth(int bits, int wanted);

} // namespace edgeshade::gl
