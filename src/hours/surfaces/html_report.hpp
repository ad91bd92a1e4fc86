#pragma once

#include "src/hours/settings.hpp"
#include "src/hours/surfaces/cells_picture.hpp"

namespace edgeshade::hours {

/// Colours of a report's pictures.
struct ReportColors {
    /// The scale's colour at a share from 0 to 1.
    std::function<DisplayColor(double share)> scale;
    double most = 1.0; ///< the value at its end, above 0
};

/// The report as one HTML page without links to other files, for screen and paper: whether the rule
/// is met, pictures from two sides with a legend, a table of windows, gardens or nodes, and all
/// that a permit needs to repeat the run. `report`: surfaceReportOf()'s. `scene`: all triangles.
std::string htmlOf(const SurfaceRun& run, const HoursSettings& settings,
                   const nlohmann::ordered_json& report, std::span<const WorldTriangle> scene,
                   const ReportColors& colors);

} // namespace edgeshade::hours
