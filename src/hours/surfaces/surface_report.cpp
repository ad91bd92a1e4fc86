#include "src/hours/surfaces/surface_report.hpp"

#include "src/hours/exposure.hpp"
#include "src/hours/part_file.hpp"
#include "src/hours/surfaces/area_sum.hpp"
#include "src/hours/surfaces/rule_checks.hpp"

#include <cmath>

namespace edgeshade::hours {
namespace {

using Json = nlohmann::ordered_json;

Json valuesJson(const AreaSum& sum) {
    return {{"min", sum.least()}, {"mean", sum.mean()}, {"max", sum.most()}};
}

/// Sums over some cells.
struct CellSums {
    AreaSum hours, energy;
    double areaAboveThreshold = 0.0; ///< m²

    double percent() const {
        return hours.area() > 0.0 ? 100.0 * (areaAboveThreshold / hours.area()) : 0.0;
    }
};

class Report {
  public:
    Report(const SurfaceRun& run, const HoursSettings& settings) : run_(run), settings_(settings) {
        if (settings.threshold)
            threshold_ = *settings.threshold * static_cast<double>(settings.days);
        width_ = static_cast<double>(settings.days);
        const double bins = std::ceil(run.possibleHours() / width_);
        histogram_.assign(static_cast<std::size_t>(std::max(1.0, bins)), 0.0);
        for (std::size_t i = 0; i < run.cells.cells.size(); ++i)
            add(i);
    }

    Json json() const {
        Json report = {{"settings", run_.settings},
                       {"scene", run_.scene},
                       {"version", run_.version},
                       {"files", run_.files},
                       {"days", settings_.days},
                       {"possible_hours", run_.possibleHours()},
                       {"cells", run_.cells.cells.size()},
                       {"inside_solids", {{"cells", inside_.count()}, {"area", inside_.area()}}},
                       {"within_others", {{"cells", within_.count()}, {"area", within_.area()}}},
                       {"area", all_.hours.area()}};
        addValues(all_, report);
        report["histogram"] = histogramJson();
        if (settings_.preset && settings_.preset->ofHalfTheArea)
            report["half_of_area"] = all_.percent() >= 50.0;
        if (Json rule = ruleChecksOf(run_, settings_); !rule.is_null())
            report["rule"] = std::move(rule);
        report["by_material"] = groupsJson(materials_, run_.materials);
        report["by_node"] = groupsJson(nodes_, run_.nodes);
        Json positions = Json::array();
        for (const Position& position : run_.positions)
            positions.push_back(jsonOf(position, run_.offset));
        report["positions"] = std::move(positions);
        report["warnings"] = run_.warnings;
        return report;
    }

  private:
    void add(std::size_t i) {
        const Cell& cell = run_.cells.cells[i];
        const double area = run_.areaOf(i), hours = run_.hoursOf(i);
        if (cell.state == CellState::inside) return inside_.add(area, hours);
        if (cell.state == CellState::within) return within_.add(area, hours);
        const WorldTriangle& triangle = run_.cells.triangleOf(cell);
        for (CellSums* sums : {&all_, &nodes_[triangle.node], &materials_[triangle.material]}) {
            sums->hours.add(area, hours);
            if (!run_.light.directKwh.empty()) sums->energy.add(area, run_.light.directKwh[i]);
            if (threshold_ && hours >= *threshold_) sums->areaAboveThreshold += area;
        }
        const auto bin = static_cast<std::size_t>(hours / width_);
        histogram_[std::min(bin, histogram_.size() - 1)] += area;
    }

    void addValues(const CellSums& sums, Json& to) const {
        to["hours"] = valuesJson(sums.hours);
        if (!run_.light.directKwh.empty()) {
            to["direct_kwh_per_m2"] = valuesJson(sums.energy);
            to["direct_kwh"] = sums.energy.sum();
        }
        if (threshold_) to["area_above_threshold_percent"] = sums.percent();
    }

    Json groupsJson(const std::map<std::uint32_t, CellSums>& groups,
                    const std::map<std::uint32_t, std::string>& names) const {
        Json json = Json::array();
        for (const auto& [index, sums] : groups) {
            Json one = {{"index", index == Exposure::none ? Json(nullptr) : Json(index)},
                        {"name", names.at(index)},
                        {"cells", sums.hours.count()},
                        {"area", sums.hours.area()}};
            addValues(sums, one);
            json.push_back(std::move(one));
        }
        return json;
    }

    Json histogramJson() const {
        Json json = Json::array();
        const double area = all_.hours.area();
        for (std::size_t b = 0; b < histogram_.size(); ++b)
            json.push_back({{"from", width_ * static_cast<double>(b)},
                            {"to", width_ * static_cast<double>(b + 1)},
                            {"area", histogram_[b]},
                            {"area_percent", area > 0.0 ? 100.0 * histogram_[b] / area : 0.0}});
        return json;
    }

    const SurfaceRun& run_;
    const HoursSettings& settings_;
    std::optional<double> threshold_; ///< hours over all days
    double width_ = 1.0;              ///< of a bin: an hour a day
    CellSums all_;
    AreaSum inside_, within_;
    std::map<std::uint32_t, CellSums> nodes_, materials_;
    std::vector<double> histogram_; ///< m²
};

} // namespace

Json surfaceReportOf(const SurfaceRun& run, const HoursSettings& settings) {
    return Report(run, settings).json();
}

} // namespace edgeshade::hours
