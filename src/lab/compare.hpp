#pragma once

#include "src/lab/compare_task.hpp"
#include "src/lab/verdicts.hpp"
#include "src/render/frame/light_methods.hpp"

#include <functional>

namespace edgeshade::lab {

/// Result of comparing one contender.
struct CompareResult {
    std::string name;
    RenderSettings settings; ///< with the layout and the bias in use
    int subpixelBits = 0;    ///< of the device
    std::size_t views = 0;
    WrongCounts counts;
    std::vector<LightMethod> lights; ///< in the last view
    std::vector<WrongCounts> byView;
    std::size_t worstView = 0;         ///< the view with the most wrong pixels in the image
    std::vector<std::uint8_t> heatmap; ///< of the worst view, RGBA
};

/// `part` of `whole` in percent; 0 if `whole` is 0.
double percent(std::size_t part, std::size_t whole);

/// Draws every view by every contender and counts wrong pixels. BLEND surfaces are left out, as
/// they take no part in shadows. The oracle sees the surfaces of `loaded`, even if a contender has
/// its own scene, and its picture is composed from theirs. `progress` receives the share done and a
/// description. Throws Error.
std::vector<CompareResult>
compareAll(const LoadedScene& loaded, const CompareTask& task,
           const std::function<void(double, const std::string&)>& progress);

} // namespace edgeshade::lab
