#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace edgeshade {

/// The n-th point of a sequence that fills [0, 1)^2 or [0, 1)^3 evenly at every length: Roberts' R2
/// and R3 (The Unreasonable Effectiveness of Quasirandom Sequences, 2018), starting at (1/2, 1/2,
/// 0). It uses multiples of the powers of 1 / phi, where phi^(dimensions + 1) = phi + 1, as 64-bit
/// fractions, the same on every machine.
template <std::size_t Dimensions>
std::array<double, Dimensions> evenly(std::uint64_t n) {
    static_assert(Dimensions == 2 || Dimensions == 3);
    constexpr std::array<std::uint64_t, 3> steps =
        Dimensions == 2
            ? std::array<std::uint64_t, 3>{0xc13fa9a902a6328full, 0x91e10da5c79e7b1cull, 0}
            : std::array<std::uint64_t, 3>{0xd1b54a32d192ed03ull, 0xabc98388fb8fac02ull,
                                           0x8cb92ba72f3d8dd7ull};
    std::array<double, Dimensions> place;
    for (std::size_t d = 0; d < Dimensions; ++d) {
        const std::uint64_t start = d < 2 ? 0x8000000000000000ull : 0;
        place[d] = std::ldexp(static_cast<double>((start + n * steps[d]) >> 11), -53);
    }
    return place;
}

} // namespace edgeshade
