#pragma once

#include "src/cli/draw_settings.hpp"
#include "src/rivals/synthetic/synthetic.hpp"

namespace edgeshade::cli {

/// The measured times: a table for each layout and silhouette, with its fit.
std::string syntheticTable(const bench::SyntheticReport& report);

/// {device, timing, settings, rows [{edges, multiplicity, layout, silhouette, ms}], fit {k0..k5,
/// mwse_percent, linear_r_squared}, fits [...]}. `fit`: for the first layout if all edges are
/// silhouette edges; `fits`: for every layout. `method`: for the opposite-vertex layouts.
nlohmann::ordered_json syntheticJson(const bench::SyntheticReport& report,
                                     MultiplicityMethod method);

} // namespace edgeshade::cli
