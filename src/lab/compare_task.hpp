#pragma once

#include "src/lab/views.hpp"
#include "src/render/frame/frame.hpp"
#include "src/scene/load.hpp"

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

} // namespace edgeshade::lab
