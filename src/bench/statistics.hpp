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

/// What each of `count` things takes, measured in turns of all of them: the median of its shares of
/// a turn, times the quickest turn. Where a machine is slower for a while it is so for all of a
/// turn, and what disturbs a thing in less than half of the turns doesn't count. Best for things
/// that take about as long as each other. `measure` says nothing where it failed, and the turn is
/// left out; nothing is returned where none is left.
std::vector<double> timesInTurns(std::size_t count, int turns,
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
