#pragma once

#include "src/bench/synthetic.hpp"
#include "src/cli/draw_settings.hpp"

namespace edgeshade::cli {

/// The measured times, a table a layout and silhouette, each with its fit.
std::string syntheticTable(const bench::SyntheticReport& report);

/// {device, timing, settings, rows [{edges, multiplicity, layout, silhouette, ms}],
/// fit {k0..k5, mwse_percent, linear_r_squared}, fits [...]}; `fit`: of the first layout, all edges
/// silhouette edges, `fits`: of every layout. `method`: of the opposite-vertex layouts.
nlohmann::ordered_json syntheticJson(const bench::SyntheticReport& report,
                                     MultiplicityMethod method);

} // namespace edgeshade::cli
