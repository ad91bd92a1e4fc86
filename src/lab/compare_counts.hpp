#pragma once

#include "src/lab/compare.hpp"
#include "src/lab/point_counts.hpp"
#include "src/render/frame/light_methods.hpp"

namespace edgeshade::lab {

/// Result of comparing one contender's counts of a light's points.
struct CountResult {
    std::string name;
    RenderSettings settings; ///< with the layout in use
    WrongSums sums;
    std::vector<LightMethod> lights; ///< in the last view
    std::vector<WrongSums> byView;
};

/// As compareAll(), for lights with an extent: counts for every view and contender how many of the
/// light's points reach each pixel, and the errors. Of a view's lights the first one is used, which
/// must have an extent. A contender that filters a soft map instead of counting points is compared
/// by its lit share of as many points, rounded. Throws Error.
std::vector<CountResult>
compareCounts(const LoadedScene& loaded, const CompareTask& task,
              const std::function<void(double, const std::string&)>& progress);

} // namespace edgeshade::lab
