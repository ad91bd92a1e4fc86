#pragma once

#include <cstddef>
#include <span>

namespace edgeshade::bench {

/// Bounds of a measured quantity.
struct Bounds {
    double low = 0.0;
    double high = 0.0;
};

/// Confidence of a bound.
enum class Surety {
    likely,  ///< 97.5 %
    certain, ///< 99.5 %
};

/// The quantile of that confidence of Student's t, with `freedom` >= 1 degrees of freedom.
double studentQuantile(std::size_t freedom, Surety surety);

/// Bounds of the mean of ln(own[i] / other[i]) over pairs of values above 0, each certain, by
/// Student's t. A spread below `leastSpread` is raised to it, as few values may agree by chance.
/// Infinite for fewer than two pairs.
Bounds logRatioBounds(std::span<const double> own, std::span<const double> other,
                      double leastSpread);

/// An upper bound, likely, of the median of values like these, whatever their distribution (by the
/// binomial distribution). It is one of the values: the largest if there are too few, 0 if there
/// are none.
double medianBelow(std::span<const double> values);

/// An upper bound, likely, of the mean of values like these, by Student's t. A single value is
/// returned itself; 0 for none.
double meanBelow(std::span<const double> values);

} // namespace edgeshade::bench
