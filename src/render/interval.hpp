#pragma once

#include <algorithm>
#include <limits>

namespace edgeshade {

/// What values span; empty, low above high, before the first.
struct Interval {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void add(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

} // namespace edgeshade
