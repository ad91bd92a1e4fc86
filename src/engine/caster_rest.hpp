#pragma once

#include <chrono>
#include <cstddef>

namespace edgeshade {

/// How long a caster has had its shape and place.
struct CasterRest {
    std::size_t version = 0; ///< unique to that shape and place
    std::chrono::steady_clock::time_point since{};
    bool moved = false; ///< it has had another shape or place

    double milliseconds() const {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - since)
            .count();
    }
    /// Whether it is a mover: it has moved, and has rested less than this since then.
    bool moves(double restMs) const { return moved && milliseconds() < restMs; }
};

} // namespace edgeshade
