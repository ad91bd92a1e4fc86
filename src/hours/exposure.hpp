#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace edgeshade::hours {

/// The surface at each pixel of a picture, and how often the sun reaches it. Rows top to bottom,
/// one value per pixel.
struct Exposure {
    /// Value of `material` and `node` where there is none.
    static constexpr std::uint32_t none = 0xFFFFFFFF;

    int width = 0;
    int height = 0;
    std::vector<std::uint16_t> lit;      ///< number of sun positions that reach the pixel's surface
    std::vector<std::uint8_t> surface;   ///< 1: the pixel has a surface
    std::vector<float> area;             ///< of that surface, scene units squared; 0: unknown
    std::vector<std::uint32_t> material; ///< index in the file; none: the ground's
    std::vector<std::uint32_t> node;     ///< index in the file; none: the ground's
};

/// Hours of sunlight on some surfaces, weighted by area.
struct HoursSummary {
    double area = 0.0; ///< scene units squared; 0: none of it is visible
    double min = 0.0, mean = 0.0, max = 0.0;
    double areaAboveThreshold = 0.0; ///< percentage with at least the threshold's hours
};

/// The summary of one material or node.
struct GroupSummary {
    std::uint32_t group = Exposure::none;
    HoursSummary hours;
};

/// A bin of hours.
struct HistogramBin {
    double from = 0.0, to = 0.0; ///< hours: from <= h < to; h <= to in the last bin
    double area = 0.0;           ///< scene units squared
};

/// Hours of `lit` positions that each stand for a step.
inline double hoursOf(std::size_t lit, std::chrono::minutes step) {
    return static_cast<double>(lit) * static_cast<double>(step.count()) / 60.0;
}

/// Summary of all pixels. `step`: the time that one lit position stands for. Pixels without area
/// count nothing.
HoursSummary summaryOf(const Exposure& exposure, std::chrono::minutes step,
                       std::optional<double> threshold);

/// The summary for each group, by number. `groups`: the group of each pixel.
std::vector<GroupSummary> summariesOf(const Exposure& exposure,
                                      std::span<const std::uint32_t> groups,
                                      std::chrono::minutes step, std::optional<double> threshold);

/// Area by hours, in `bins` bins of `width` hours from 0 on; the last one holds all larger values.
/// `width`, `bins`: above 0.
std::vector<HistogramBin> histogramOf(const Exposure& exposure, std::chrono::minutes step,
                                      double width, std::size_t bins);

} // namespace edgeshade::hours
