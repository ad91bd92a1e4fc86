#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace edgeshade::bench {

/// The median; of an even number of values the mean of the middle two. 0 for no values.
double median(std::vector<double> values);

/// The smallest value that at least `share` (0..1] of the values don't exceed. 0 for no values.
double percentile(std::vector<double> values, double share);

/// Distribution of times.
struct Spread {
    double median = 0.0;
    double p95 = 0.0;
    double max = 0.0;
};
Spread spreadOf(const std::vector<double>& values);

/// Distribution of the ratios of paired values.
struct Ratios {
    double median = 0.0;
    double min = 0.0;
    double max = 0.0;
};
/// Ratios own[i] / other[i]; both have the same length, and `other` is above 0.
Ratios ratiosOf(std::span<const double> own, std::span<const double> other);

/// The time of each of `count` things, measured in turns of all of them: the median of its shares
/// of a turn, times the fastest turn. A machine that is slower for a while is so for a whole turn,
/// and disturbances in less than half of the turns don't count. Works best for things that take
/// about equally long. `measure` returns null on failure, and the turn is skipped; the result is
/// empty if none remains.
std::vector<double> timesInTurns(std::size_t count, int turns,
                                 const std::function<std::optional<double>(std::size_t)>& measure);

/// The least-squares line through points (x, y), and its quality.
struct Line {
    double slope = 0.0;
    double offset = 0.0;
    double rSquared = 0.0; ///< share of y's variance explained by the line
};
/// Needs at least two points with different x.
Line fittedLine(std::span<const double> x, std::span<const double> y);

} // namespace edgeshade::bench
