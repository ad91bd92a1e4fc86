#pragma once

#include "src/lab/compare.hpp"
#include "src/lab/point_counts.hpp"
#include "src/render/frame/light_methods.hpp"

namespace edgeshade::lab {

/// What comparing one contender's counts of a light's points found.
struct CountResult {
    std::string name;
    RenderSettings settings; ///< with the layout that was used
    WrongSums sums;
    std::vector<LightMethod> lights; ///< of the last view
    std::vector<WrongSums> byView;
};

/// Like compareAll(), of lights with an extent: counts, for every view and contender, how many of
/// its points reach each pixel, and what of that is wrong. Of several lights of a view the first
/// one counts, which must have an extent. Of a contender that counts no points but filters a soft
/// map, the share that is lit stands for as many points as it would count, rounded. Throws Error.
std::vector<CountResult>
compareCounts(const LoadedScene& loaded, const CompareTask& task,
              const std::function<void(double, const std::string&)>& progress);

} // namespace edgeshade::lab
