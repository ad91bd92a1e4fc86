#pragma once

#include "preprocess/base/box.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace edgeshade {

/// Inserts two zeros after each of the lowest 21 bits; the others must be 0.
inline std::uint64_t spreadByThree(std::uint64_t bits) {
    bits = (bits | bits << 32) & 0x001F00000000FFFFu;
    bits = (bits | bits << 16) & 0x001F0000FF0000FFu;
    bits = (bits | bits << 8) & 0x100F00F00F00F00Fu;
    bits = (bits | bits << 4) & 0x10C30C30C30C30C3u;
    return (bits | bits << 2) & 0x1249249249249249u;
}

/// A point's place on the Morton curve through the box, 63 bits; coordinates outside the box count
/// as its nearest ones, and those that aren't numbers as its lowest.
inline std::uint64_t mortonCode(const glm::dvec3& point, const Box& all) {
    std::uint64_t code = 0;
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        const double extent = all.high[axis] - all.low[axis];
        const double at = extent > 0.0 ? (point[axis] - all.low[axis]) / extent : 0.0;
        const double inside = at > 0.0 ? std::min(at, 1.0) : 0.0;
        code |= spreadByThree(static_cast<std::uint64_t>(inside * 0x1FFFFF)) << axis;
    }
    return code;
}

/// A Morton code as a sort key.
inline std::array<std::uint32_t, 2> mortonKey(std::uint64_t code) {
    return {static_cast<std::uint32_t>(code >> 31), static_cast<std::uint32_t>(code & 0x7FFFFFFFu)};
}

} // namespace edgeshade
