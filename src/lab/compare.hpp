#pragma once

#include "src/lab/verdicts.hpp"
#include "src/lab/views.hpp"
#include "src/render/frame/frame.hpp"
#include "src/render/frame/prepare_scene.hpp"
#include "src/scene/load.hpp"

#include <functional>
#include <memory>
#include <optional>

namespace edgeshade::lab {

/// One way of drawing that is compared.
struct Contender {
    std::string name;
    RenderSettings settings;
    std::optional<SidesLayout> layout; ///< nothing: the best that the GL has
    std::optional<int> depthSlices;    ///< nothing: as many as pay
    bool tuneMapBias = false; ///< maps: try several biases on the first views, keep the best
    std::shared_ptr<const LoadedScene> scene; ///< with other casters; null: compareAll()'s own
};

/// What is compared.
struct CompareTask {
    std::vector<LabView> views;
    int width = 1920;
    int height = 1080;
    gl::Limits limits = gl::Limits::device;
    std::optional<double> near; ///< nothing: fitted to each view
    std::vector<Light> lights;  ///< used in every view instead of its own; may be empty
    std::vector<Contender> contenders;
};

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
