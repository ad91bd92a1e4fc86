#pragma once

#include "src/lab/compare_task.hpp"
#include "src/lab/verdicts.hpp"
#include "src/render/frame/light_methods.hpp"

#include <functional>

namespace edgeshade::lab {

/// What comparing one contender found.
struct CompareResult {
    std::string name;
    RenderSettings settings; ///< with the layout and the bias that were used
    int subpixelBits = 0;    ///< of the device
    std::size_t views = 0;
    WrongCounts counts;
    std::vector<LightMethod> lights; ///< of the last view
    std::vector<WrongCounts> byView;
    std::size_t worstView = 0;         ///< most pixels wrong in the image
    std::vector<std::uint8_t> heatmap; ///< of the worst view, RGBA
};

/// Part of the whole in percent; 0 of nothing.
double percent(std::size_t part, std::size_t whole);

/// Draws every view by every contender and counts what is wrong. BLEND surfaces are left out: they
/// take no part in shadows. The oracle sees the surfaces of `loaded`, whatever scenes contenders
/// have, and its picture is put together from theirs. `progress` gets the share done and what is
/// being done. Throws Error.
std::vector<CompareResult>
compareAll(const LoadedScene& loaded, const CompareTask& task,
           const std::function<void(double, const std::string&)>& progress);

} // namespace edgeshade::lab
