#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace edgeshade::bench {

/// Half of the values are at most as large; of an even number the mean of the middle two. 0 for no
/// values.
double median(std::vector<double> values);

/// The smallest value that at least `share` (0..1] of the values don't exceed. 0 for no values.
double percentile(std::vector<double> values, double share);

/// How times spread.
struct Spread {
    double median = 0.0;
    double p95 = 0.0;
    double max = 0.0;
};
Spread spreadOf(const std::vector<double>& values);

/// How the ratios of paired values spread.
struct Ratios {
    double median = 0.0;
    double min = 0.0;
    double max = 0.0;
};
/// own[i] / other[i]; as many of both, `other` above 0.
Ratios ratiosOf(std::span<const double> own, std::span<const double> other);

/// The least of what `measure` says of each of `count` things: what disturbs only ever adds. The
/// things take turns, so that it hits all alike, and turns go on until `quietTurns` in a row have
/// lowered none by more than a hundredth, ten times as many at the most. Nothing from `measure`:
/// this one failed; nothing in the result: all did.
std::vector<std::optional<double>>
leastTimes(std::size_t count, int quietTurns,
           const std::function<std::optional<double>(std::size_t)>& measure);

/// The line that least squares put through points (x, y), and how well it fits.
struct Line {
    double slope = 0.0;
    double offset = 0.0;
    double rSquared = 0.0; ///< share of y's variance that the line explains
};
/// At least two points with different x.
Line fittedLine(std::span<const double> x, std::span<const double> y);

} // namespace edgeshade::bench
