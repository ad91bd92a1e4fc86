#include "src/hours/intervals.hpp"

namespace edgeshade::hours {

std::vector<Interval> litIntervals(std::span<const sun::Instant> times,
                                   const std::vector<bool>& lit, std::chrono::minutes step,
                                   std::chrono::minutes offset) {
    const auto half = std::chrono::duration_cast<std::chrono::seconds>(step) / 2;
    std::vector<Interval> intervals;
    for (std::size_t i = 0; i < times.size(); ++i) {
        if (!lit[i]) continue;
        const Interval one{times[i] - half, times[i] + half};
        const bool sameDay =
            !intervals.empty() && sun::startOfDay({one.first, offset}) ==
                                      sun::startOfDay({intervals.back().first, offset});
        if (sameDay && intervals.back().second == one.first)
            intervals.back().second = one.second;
        else
            intervals.push_back(one);
    }
    return intervals;
}

} // namespace edgeshade::hours
