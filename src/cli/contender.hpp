#pragma once

#include "src/cli/draw_settings.hpp"
#include "src/cli/options.hpp"
#include "src/lab/compare.hpp"

namespace edgeshade::cli {

/// Makes a contender for comparison with the oracle; a map's bias is tuned unless it was typed.
/// `scene`: the scene with the settings' casters; null: the call's own.
lab::Contender contenderOf(const std::string& name, const DrawSettings& settings,
                           std::shared_ptr<const LoadedScene> scene);

/// Sets the task's views and lights: `views` of the lab's views, or only the typed camera's if no
/// number of views was typed. The lab's views have their own lights, unless lights or --lights were
/// typed. Throws Error(usage) for too many lights.
void lookAt(lab::CompareTask& task, const ViewOptions& view, const Scene& scene, int views,
            bool viewsTyped);

} // namespace edgeshade::cli
