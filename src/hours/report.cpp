#include "src/hours/report.hpp"

#include "src/hours/intervals.hpp"
#include "src/hours/part_file.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade::hours {
namespace {

using Json = nlohmann::ordered_json;

Json hoursJson(const HoursSummary& summary) {
    return {{"min", summary.min}, {"mean", summary.mean}, {"max", summary.max}};
}

Json groupsJson(const Part& whole, const HoursSettings& settings,
                const std::vector<std::uint32_t>& groups,
                const std::map<std::uint32_t, std::string>& names) {
    Json json = Json::array();
    for (const GroupSummary& group :
         summariesOf(whole.exposure, groups, settings.step, totalThreshold(settings))) {
        const bool known = group.group != Exposure::none;
        Json one = {{"index", known ? Json(group.group) : Json(nullptr)},
                    {"name", known ? names.at(group.group) : "ground"},
                    {"area", group.hours.area},
                    {"hours", hoursJson(group.hours)}};
        if (settings.threshold)
            one["area_above_threshold_percent"] = group.hours.areaAboveThreshold;
        json.push_back(std::move(one));
    }
    return json;
}

/// The histogram, in bins of one hour a day.
Json histogramJson(const Part& whole, const HoursSettings& settings, double area) {
    const auto width = static_cast<double>(settings.days);
    const double possible = possibleHours(whole, settings);
    const auto bins = static_cast<std::size_t>(std::max(1.0, std::ceil(possible / width)));
    Json json = Json::array();
    for (const HistogramBin& bin : histogramOf(whole.exposure, settings.step, width, bins))
        json.push_back({{"from", bin.from},
                        {"to", bin.to},
                        {"area", bin.area},
                        {"area_percent", area > 0.0 ? 100.0 * bin.area / area : 0.0}});
    return json;
}

Json probesJson(const Part& whole, const HoursSettings& settings) {
    std::vector<sun::Instant> times;
    for (const Position& position : whole.positions)
        times.push_back(position.time);
    Json json = Json::array();
    for (const Probe& probe : whole.probes) {
        Json lit = Json::array();
        for (const Interval& interval :
             litIntervals(times, probe.lit, settings.step, settings.offset))
            lit.push_back({sun::textOf(sun::LocalTime{interval.first, settings.offset}),
                           sun::textOf(sun::LocalTime{interval.second, settings.offset})});
        const auto count = static_cast<std::size_t>(std::ranges::count(probe.lit, true));
        json.push_back(
            {{"point", {probe.point.x, probe.point.y, probe.point.z}},
             {"normal", probe.normal ? Json({probe.normal->x, probe.normal->y, probe.normal->z})
                                     : Json(nullptr)},
             {"hours", hoursOf(count, settings.step)},
             {"lit", std::move(lit)}});
    }
    return json;
}

} // namespace

double possibleHours(const Part& whole, const HoursSettings& settings) {
    return hoursOf(whole.positions.size(), settings.step);
}

std::optional<double> totalThreshold(const HoursSettings& settings) {
    if (!settings.threshold) return std::nullopt;
    return *settings.threshold * static_cast<double>(settings.days);
}

Json reportOf(const Part& whole, const HoursSettings& settings) {
    const Exposure& exposure = whole.exposure;
    const HoursSummary all = summaryOf(exposure, settings.step, totalThreshold(settings));
    Json positions = Json::array();
    for (const Position& position : whole.positions)
        positions.push_back(jsonOf(position, whole.offset));
    std::size_t visible = 0, unknown = 0;
    for (std::size_t i = 0; i < exposure.surface.size(); ++i) {
        visible += exposure.surface[i];
        unknown += exposure.surface[i] != 0 && exposure.area[i] == 0.0f;
    }
    Json report = {{"size", {exposure.width, exposure.height}},
                   {"camera", whole.camera},
                   {"settings", whole.settings},
                   {"scene", whole.scene},
                   {"days", settings.days},
                   {"possible_hours", possibleHours(whole, settings)},
                   {"visible_pixels", visible},
                   {"pixels_without_area", unknown},
                   {"area", all.area},
                   {"hours", hoursJson(all)},
                   {"histogram", histogramJson(whole, settings, all.area)}};
    if (settings.threshold) {
        report["area_above_threshold_percent"] = all.areaAboveThreshold;
        if (settings.preset && settings.preset->ofHalfTheArea)
            report["half_of_area"] = all.areaAboveThreshold >= 50.0;
    }
    report["by_material"] = groupsJson(whole, settings, exposure.material, whole.materials);
    report["by_node"] = groupsJson(whole, settings, exposure.node, whole.nodes);
    report["probes"] = probesJson(whole, settings);
    report["positions"] = std::move(positions);
    report["warnings"] = whole.warnings;
    return report;
}

} // namespace edgeshade::hours
