#pragma once

#include "src/lab/views.hpp"
#include "src/render/frame/frame.hpp"
#include "src/scene/load.hpp"

#include <memory>
#include <optional>

namespace edgeshade::lab {

/// A way of drawing to compare.
struct Contender {
    std::string name;
    RenderSettings settings;
    std::optional<SidesLayout> layout; ///< null: the GL's best
    std::optional<int> depthSlices;    ///< null: as many as pay
    bool tuneMapBias = false; ///< maps: try several biases on the first views, keep the best
    std::shared_ptr<const LoadedScene> scene; ///< a scene with other casters; null: compareAll()'s
                                              ///< scene
};

/// A comparison.
struct CompareTask {
    std::vector<LabView> views;
    int width = 1920;
    int height = 1080;
    gl::Limits limits = gl::Limits::device;
    std::optional<double> near; ///< null: fitted to each view
    std::vector<Light> lights;  ///< replace every view's own lights; may be empty
    std::vector<Contender> contenders;
};

} // namespace edgeshade::lab
