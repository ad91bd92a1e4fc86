#include "src/hours/surfaces/rule_checks.hpp"

#include "src/hours/intervals.hpp"
#include "src/hours/surfaces/area_sum.hpp"

#include <algorithm>

namespace edgeshade::hours {
namespace {

using Json = nlohmann::ordered_json;

/// Share of a garden's area that needs the threshold's hours (BRE 209, 3.3).
constexpr double neededPercent = 50.0;

Json jsonOf(const glm::dvec3& vector) {
    return {vector.x, vector.y, vector.z};
}

double hoursADay(const SurfaceRun& run, const HoursSettings& settings, std::size_t cell) {
    return run.hoursOf(cell) / static_cast<double>(settings.days);
}

/// The times between which the sun reaches a cell.
Json timesOf(const SurfaceRun& run, std::size_t cell) {
    std::vector<sun::Instant> times;
    std::vector<bool> lit;
    const std::size_t row = cell * bytesOfRow(run.positions.size());
    for (std::size_t p = 0; p < run.positions.size(); ++p) {
        times.push_back(run.positions[p].time);
        lit.push_back((run.light.bits[row + p / 8] >> (7 - p % 8) & 1) != 0);
    }
    Json json = Json::array();
    for (const Interval& interval : litIntervals(times, lit, run.step, run.offset))
        json.push_back({sun::textOf(sun::LocalTime{interval.first, run.offset}),
                        sun::textOf(sun::LocalTime{interval.second, run.offset})});
    return json;
}

Json windowChecks(const SurfaceRun& run, const HoursSettings& settings) {
    std::map<std::uint32_t, std::size_t> windowsOfNode, numbers;
    for (const Cell& cell : run.cells.cells)
        ++windowsOfNode[run.cells.triangleOf(cell).node];
    Json checks = Json::array();
    for (std::size_t i = 0; i < run.cells.cells.size(); ++i) {
        const Cell& cell = run.cells.cells[i];
        const WorldTriangle& triangle = run.cells.triangleOf(cell);
        std::string name = run.nodes.at(triangle.node);
        if (windowsOfNode[triangle.node] > 1)
            name += ", " + std::to_string(++numbers[triangle.node]);
        const double hours = hoursADay(run, settings, i);
        checks.push_back({{"name", name},
                          {"node", triangle.node},
                          {"material", run.materials.at(triangle.material)},
                          {"point", jsonOf(cell.point)},
                          {"normal", jsonOf(cell.normal)},
                          {"area", run.areaOf(i)},
                          {"hours", hours},
                          {"lit", timesOf(run, i)},
                          {"inside_solid", cell.state == CellState::inside},
                          {"passes", hours >= *settings.threshold}});
    }
    return checks;
}

Json gardenChecks(const SurfaceRun& run, const HoursSettings& settings) {
    struct Garden {
        AreaSum hours;
        double enough = 0.0; ///< m² with the threshold's hours
    };
    std::map<std::uint32_t, Garden> gardens;
    for (std::size_t i = 0; i < run.cells.cells.size(); ++i) {
        if (!run.isCounted(i)) continue;
        Garden& garden = gardens[run.cells.triangleOf(run.cells.cells[i]).node];
        const double hours = hoursADay(run, settings, i);
        garden.hours.add(run.areaOf(i), hours);
        if (hours >= *settings.threshold) garden.enough += run.areaOf(i);
    }
    Json checks = Json::array();
    for (const auto& [node, garden] : gardens) {
        const double percent = 100.0 * garden.enough / garden.hours.area();
        checks.push_back({{"name", run.nodes.at(node)},
                          {"node", node},
                          {"area", garden.hours.area()},
                          {"hours", garden.hours.mean()},
                          {"area_above_threshold_percent", percent},
                          {"passes", percent >= neededPercent}});
    }
    return checks;
}

} // namespace

Json ruleChecksOf(const SurfaceRun& run, const HoursSettings& settings) {
    const bool ofGardens = settings.preset && settings.preset->ofHalfTheArea;
    if (!settings.threshold || (!run.ofWindows && !ofGardens)) return nullptr;
    Json checks = run.ofWindows ? windowChecks(run, settings) : gardenChecks(run, settings);
    const auto passing = std::ranges::count_if(
        checks, [](const Json& check) { return check["passes"].get<bool>(); });
    Json rule = {{"preset", settings.preset ? Json(settings.preset->name) : Json(nullptr)},
                 {"source", settings.preset ? Json(settings.preset->source) : Json(nullptr)},
                 {"of", run.ofWindows ? "windows" : "gardens"},
                 {"threshold_hours", *settings.threshold}};
    if (!run.ofWindows) rule["needed_area_percent"] = neededPercent;
    rule["passes"] = passing == static_cast<std::ptrdiff_t>(checks.size());
    rule["passing"] = passing;
    rule["checks"] = std::move(checks);
    return rule;
}

} // namespace edgeshade::hours
