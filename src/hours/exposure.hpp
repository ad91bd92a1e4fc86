#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace edgeshade::hours {

/// What a picture's pixels show and how often the sun sees it, rows top to bottom, one of each a
/// pixel.
struct Exposure {
    /// Of `material` and `node`: none.
    static constexpr std::uint32_t none = 0xFFFFFFFF;

    int width = 0;
    int height = 0;
    std::vector<std::uint16_t> lit;      ///< sun positions that see the pixel's surface
    std::vector<std::uint8_t> surface;   ///< 1: there is one
    std::vector<float> area;             ///< of that surface, scene units squared; 0: not known
    std::vector<std::uint32_t> material; ///< in the file; none: the ground's
    std::vector<std::uint32_t> node;     ///< likewise
};

/// Hours of sun of some surfaces, by their area.
struct HoursSummary {
    double area = 0.0; ///< scene units squared; 0: nothing of it is seen
    double min = 0.0, mean = 0.0, max = 0.0;
    double areaAboveThreshold = 0.0; ///< percent, with at least the threshold's hours
};

/// Of one material or node.
struct GroupSummary {
    std::uint32_t group = Exposure::none;
    HoursSummary hours;
};

/// A bin of hours.
struct HistogramBin {
    double from = 0.0, to = 0.0; ///< hours: from <= h < to, of the last bin <= to
    double area = 0.0;           ///< scene units squared
};

/// What so many lit positions are that each stand for a step.
inline double hoursOf(std::size_t lit, std::chrono::minutes step) {
    return static_cast<double>(lit) * static_cast<double>(step.count()) / 60.0;
}

/// `step`: what one lit position stands for. Pixels without area weigh nothing.
HoursSummary summaryOf(const Exposure& exposure, std::chrono::minutes step,
                       std::optional<double> threshold);

/// The same for each group, by number. `groups`: of each pixel.
std::vector<GroupSummary> summariesOf(const Exposure& exposure,
                                      std::span<const std::uint32_t> groups,
                                      std::chrono::minutes step, std::optional<double> threshold);

/// Area by hours, in `bins` bins that are so many hours wide each, from 0; what has more is in the
/// last one. `width`, `bins`: above 0.
std::vector<HistogramBin> histogramOf(const Exposure& exposure, std::chrono::minutes step,
                                      double width, std::size_t bins);

} // namespace edgeshade::hours
