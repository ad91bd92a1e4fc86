#pragma once

#include <optional>
#include <span>
#include <vector>

namespace edgeshade::bench {

/// What a setting costs, and what is wrong for it. Less of both is better.
struct Trade {
    double milliseconds = 0.0;
    double wrongPercent = 0.0;
};

/// Which are on the Pareto front: no other is better in one and no worse in the other. Of equal
/// ones all are.
std::vector<bool> paretoFront(std::span<const Trade> trades);

/// What a user demands of a setting.
struct Demand {
    std::optional<double> mostMilliseconds;
    std::optional<double> mostWrongPercent;
};

/// The setting to take: with a limit on what is wrong the fastest within both limits, else the one
/// with the fewest wrong pixels. Nothing where none is within the limits.
std::optional<std::size_t> bestWithin(std::span<const Trade> trades, const Demand& demand);

} // namespace edgeshade::bench
