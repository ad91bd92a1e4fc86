#pragma once

#include "src/hours/settings.hpp"
#include "src/hours/surfaces/surface_run.hpp"

namespace edgeshade::hours {

/// The report of a run over surfaces. Shares are of the counted cells, by true area in square
/// metres. `settings`: the run's.
nlohmann::ordered_json surfaceReportOf(const SurfaceRun& run, const HoursSettings& settings);

} // namespace edgeshade::hours
