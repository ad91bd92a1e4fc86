#include "src/bench/confidence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace edgeshade::bench {
namespace {

struct Sample {
    double mean = 0.0;
    double deviation = 0.0; ///< standard deviation of the values
};

/// Mean and deviation of at least two values.
Sample sampleOf(std::span<const double> values) {
    const double count = static_cast<double>(values.size());
    Sample sample{std::accumulate(values.begin(), values.end(), 0.0) / count, 0.0};
    for (const double value : values)
        sample.deviation += (value - sample.mean) * (value - sample.mean);
    sample.deviation = std::sqrt(sample.deviation / (count - 1.0));
    return sample;
}

/// Error margin of the mean of `count` values.
double marginOf(double deviation, std::size_t count, Surety surety) {
    return studentQuantile(count - 1, surety) * deviation / std::sqrt(static_cast<double>(count));
}

} // namespace

double studentQuantile(std::size_t freedom, Surety surety) {
    constexpr std::size_t few = 6;
    constexpr double likely[few] = {12.706, 4.303, 3.182, 2.776, 2.571, 2.447};
    constexpr double certain[few] = {63.657, 9.925, 5.841, 4.604, 4.032, 3.707};
    if (freedom <= few) return (surety == Surety::likely ? likely : certain)[freedom - 1];
    // Fisher's expansion around the normal distribution (Abramowitz and Stegun 26.7.5).
    const double z = surety == Surety::likely ? 1.95996 : 2.57583;
    const double z3 = z * z * z, z5 = z3 * z * z, z7 = z5 * z * z;
    const double n = static_cast<double>(freedom);
    return z + (z3 + z) / (4.0 * n) + (5.0 * z5 + 16.0 * z3 + 3.0 * z) / (96.0 * n * n) +
           (3.0 * z7 + 19.0 * z5 + 17.0 * z3 - 15.0 * z) / (384.0 * n * n * n);
}

Bounds logRatioBounds(std::span<const double> own, std::span<const double> other,
                      double leastSpread) {
    const std::size_t count = std::min(own.size(), other.size());
    if (count < 2)
        return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    std::vector<double> ratios;
    for (std::size_t i = 0; i < count; ++i)
        ratios.push_back(std::log(own[i] / other[i]));
    const Sample sample = sampleOf(ratios);
    const double margin = marginOf(std::max(sample.deviation, leastSpread), count, Surety::certain);
    return {sample.mean - margin, sample.mean + margin};
}

double medianBelow(std::span<const double> values) {
    if (values.empty()) return 0.0;
    std::vector<double> sorted(values.begin(), values.end());
    std::sort(sorted.begin(), sorted.end());
    const std::size_t count = sorted.size();
    const double n = static_cast<double>(count);
    if (count > 200) { // normal approximation of the binomial
        const double rank = std::ceil(0.5 * n + 1.96 * 0.5 * std::sqrt(n)) + 1.0;
        return sorted[static_cast<std::size_t>(rank) - 1];
    }
    // The k-th smallest is below the median if at least k of the values are.
    std::size_t best = count;
    double chance = 0.0, exactly = std::pow(0.5, n);
    for (std::size_t k = count; k >= 1; --k) {
        chance += exactly;
        if (chance > 0.025) break;
        best = k;
        exactly *= static_cast<double>(k) / static_cast<double>(count - k + 1);
    }
    return sorted[best - 1];
}

double meanBelow(std::span<const double> values) {
    if (values.size() < 2) return values.empty() ? 0.0 : values.front();
    const Sample sample = sampleOf(values);
    return sample.mean + marginOf(sample.deviation, values.size(), Surety::likely);
}

} // namespace edgeshade::bench
