#include "src/hours/exposure.hpp"

#include <algorithm>
#include <map>

namespace edgeshade::hours {
namespace {

/// Sums pixels one after the other, so that results are the same everywhere.
class Sum {
  public:
    Sum(std::chrono::minutes step, std::optional<double> threshold)
        : step_(step), threshold_(threshold) {}

    void add(const Exposure& exposure, std::size_t pixel) {
        const double area = exposure.area[pixel];
        const double hours = hoursOf(exposure.lit[pixel], step_);
        sum_.min = sum_.area == 0.0 ? hours : std::min(sum_.min, hours);
        sum_.max = std::max(sum_.max, hours);
        sum_.area += area;
        sum_.mean += area * hours;
        if (threshold_ && hours >= *threshold_) sum_.areaAboveThreshold += area;
    }

    HoursSummary result() const {
        HoursSummary result = sum_;
        if (result.area == 0.0) return {};
        result.mean /= result.area;
        result.areaAboveThreshold = 100.0 * (result.areaAboveThreshold / result.area);
        return result;
    }

  private:
    std::chrono::minutes step_;
    std::optional<double> threshold_;
    HoursSummary sum_;
};

template <class Use>
void forEachWeighed(const Exposure& exposure, Use use) {
    for (std::size_t i = 0; i < exposure.lit.size(); ++i)
        if (exposure.surface[i] != 0 && exposure.area[i] > 0.0f) use(i);
}

} // namespace

HoursSummary summaryOf(const Exposure& exposure, std::chrono::minutes step,
                       std::optional<double> threshold) {
    Sum sum(step, threshold);
    forEachWeighed(exposure, [&](std::size_t pixel) { sum.add(exposure, pixel); });
    return sum.result();
}

std::vector<GroupSummary> summariesOf(const Exposure& exposure,
                                      std::span<const std::uint32_t> groups,
                                      std::chrono::minutes step, std::optional<double> threshold) {
    std::map<std::uint32_t, Sum> sums;
    forEachWeighed(exposure, [&](std::size_t pixel) {
        sums.try_emplace(groups[pixel], step, threshold).first->second.add(exposure, pixel);
    });
    std::vector<GroupSummary> summaries;
    for (const auto& [group, sum] : sums)
        summaries.push_back({group, sum.result()});
    return summaries;
}

std::vector<HistogramBin> histogramOf(const Exposure& exposure, std::chrono::minutes step,
                                      double width, std::size_t bins) {
    std::vector<HistogramBin> histogram;
    for (std::size_t b = 0; b < bins; ++b)
        histogram.push_back(
            {width * static_cast<double>(b), width * static_cast<double>(b + 1), 0.0});
    forEachWeighed(exposure, [&](std::size_t pixel) {
        const double hours = hoursOf(exposure.lit[pixel], step);
        const auto bin = static_cast<std::size_t>(hours / width);
        histogram[std::min(bin, bins - 1)].area += exposure.area[pixel];
    });
    return histogram;
}

} // namespace edgeshade::hours
