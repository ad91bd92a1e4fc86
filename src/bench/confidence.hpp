#pragma once

#include <cstddef>
#include <span>

namespace edgeshade::bench {

/// What something keeps within, as far as was measured.
struct Bounds {
    double low = 0.0;
    double high = 0.0;
};

/// How sure a bound is.
enum class Surety {
    likely,  ///< 97.5 %
    certain, ///< 99.5 %
};

/// That quantile of Student's t with `freedom` >= 1 degrees of freedom.
double studentQuantile(std::size_t freedom, Surety surety);

/// Certain bounds, either of them, of the mean of ln(own[i] / other[i]) over as many pairs of
/// values above 0, with Student's t. A spread below `leastSpread` is taken for that: few values may
/// happen to agree. Infinite for fewer than two pairs.
Bounds logRatioBounds(std::span<const double> own, std::span<const double> other,
                      double leastSpread);

/// What the median of values like these is likely below, whatever they are distributed like: one of
/// them (by the binomial distribution). The largest where there are too
/// few for that; 0 for no values.
double medianBelow(std::span<const double> values);

/// What the mean of values like these is likely below, with Student's t; for a single value that
/// itself, 0 for none.
double meanBelow(std::span<const double> values);

} // namespace edgeshade::bench
