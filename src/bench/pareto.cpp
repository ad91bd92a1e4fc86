#include "src/bench/pareto.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

namespace edgeshade::bench {
namespace {

bool isWorse(const Trade& trade, const Trade& than) {
    return than.milliseconds <= trade.milliseconds && than.wrongPercent <= trade.wrongPercent &&
           (than.milliseconds < trade.milliseconds || than.wrongPercent < trade.wrongPercent);
}

} // namespace

std::vector<bool> paretoFront(std::span<const Trade> trades) {
    std::vector<bool> front;
    for (const Trade& trade : trades)
        front.push_back(std::none_of(trades.begin(), trades.end(),
                                     [&](const Trade& other) { return isWorse(trade, other); }));
    return front;
}

std::optional<std::size_t> bestWithin(std::span<const Trade> trades, const Demand& demand) {
    constexpr double any = std::numeric_limits<double>::infinity();
    const auto rank = [&](const Trade& trade) {
        return demand.mostWrongPercent ? std::tuple(trade.milliseconds, trade.wrongPercent)
                                       : std::tuple(trade.wrongPercent, trade.milliseconds);
    };
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < trades.size(); ++i) {
        const bool fits = trades[i].milliseconds <= demand.mostMilliseconds.value_or(any) &&
                          trades[i].wrongPercent <= demand.mostWrongPercent.value_or(any);
        if (fits && (!best || rank(trades[i]) < rank(trades[*best]))) best = i;
    }
    return best;
}

} // namespace edgeshade::bench
