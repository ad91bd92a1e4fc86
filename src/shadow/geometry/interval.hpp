#pragma once

#include <algorithm>
#include <limits>

namespace edgeshade {

/// The range of values added; before the first it is empty, with low above high.
struct Interval {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void add(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    void add(const Interval& other) {
        low = std::min(low, other.low);
        high = std::max(high, other.high);
    }
};

} // namespace edgeshade
