#include "src/bench/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace edgeshade::bench {
namespace {

double meanOf(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

} // namespace

double median(std::vector<double> values) {
    if (values.empty()) return 0.0;
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

double percentile(std::vector<double> values, double share) {
    if (values.empty()) return 0.0;
    std::sort(values.begin(), values.end());
    const double rank = std::ceil(share * static_cast<double>(values.size()));
    const auto index = static_cast<std::size_t>(std::max(1.0, rank)) - 1;
    return values[std::min(index, values.size() - 1)];
}

Spread spreadOf(const std::vector<double>& values) {
    return {median(values), percentile(values, 0.95), percentile(values, 1.0)};
}

Ratios ratiosOf(std::span<const double> own, std::span<const double> other) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < own.size(); ++i)
        ratios.push_back(own[i] / other[i]);
    if (ratios.empty()) return {};
    const auto [least, most] = std::minmax_element(ratios.begin(), ratios.end());
    return {median(ratios), *least, *most};
}

std::vector<double> timesInTurns(std::size_t count, int turns,
                                 const std::function<std::optional<double>(std::size_t)>& measure) {
    std::vector<std::vector<double>> shares(count); // one per turn
    double quickest = std::numeric_limits<double>::infinity();
    for (int turn = 0; turn < turns; ++turn) {
        std::vector<double> times;
        for (std::size_t i = 0; i < count; ++i)
            if (const auto time = measure(i)) times.push_back(*time);
        if (times.size() < count) continue;
        const double whole = std::reduce(times.begin(), times.end());
        quickest = std::min(quickest, whole);
        for (std::size_t i = 0; i < count; ++i)
            shares[i].push_back(times[i] / whole);
    }
    if (!std::isfinite(quickest)) return {};
    std::vector<double> times;
    for (std::vector<double>& share : shares)
        times.push_back(median(std::move(share)) * quickest);
    return times;
}

Line fittedLine(std::span<const double> x, std::span<const double> y) {
    const double meanX = meanOf(x), meanY = meanOf(y);
    double xx = 0.0, xy = 0.0, yy = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        xx += (x[i] - meanX) * (x[i] - meanX);
        xy += (x[i] - meanX) * (y[i] - meanY);
        yy += (y[i] - meanY) * (y[i] - meanY);
    }
    const double slope = xy / xx;
    return {slope, meanY - slope * meanX, yy == 0.0 ? 1.0 : xy * xy / (xx * yy)};
}

} // namespace edgeshade::bench
