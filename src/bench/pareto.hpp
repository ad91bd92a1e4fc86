#pragma once

#include <optional>
#include <span>
#include <vector>

namespace edgeshade::bench {

/// Cost and errors of a setting; less is better for both.
struct Trade {
    double milliseconds = 0.0;
    double wrongPercent = 0.0;
};

/// Finds the settings on the Pareto front: no other setting is better in one respect and no worse
/// in the other. Equal settings are all on it.
std::vector<bool> paretoFront(std::span<const Trade> trades);

/// A user's limits on a setting.
struct Demand {
    std::optional<double> mostMilliseconds;
    std::optional<double> mostWrongPercent;
};

/// The setting to use: with a limit on errors the fastest within both limits, otherwise the one
/// with the fewest wrong pixels. Null if none is within the limits.
std::optional<std::size_t> bestWithin(std::span<const Trade> trades, const Demand& demand);

} // namespace edgeshade::bench
