#pragma once

#include "src/hours/settings.hpp"
#include "src/hours/surfaces/surface_run.hpp"

namespace edgeshade::hours {

/// Whether a rule is met, by item.
///
///     {"preset" or null, "source" or null, "of": "windows" or "gardens", "threshold_hours",
///      "needed_area_percent" of gardens, "passes", "passing", "checks": [...]}
///
/// A window passes with at least the threshold's hours a day; a check has its name, node, material,
/// point, normal, area, hours a day, the times with sun, whether it lies in a solid, and whether it
/// passes. Windows of one node are numbered, "name, 2". A garden is the chosen surface of a node,
/// and passes if at least half of its area has these hours; cells left out don't count.
///
/// Null if nothing is to be checked: there is no threshold, or it is neither of windows nor of half
/// of an area. `settings`: the run's.
nlohmann::ordered_json ruleChecksOf(const SurfaceRun& run, const HoursSettings& settings);

} // namespace edgeshade::hours
