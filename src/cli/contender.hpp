#pragma once

#include "src/cli/draw_settings.hpp"
#include "src/cli/options.hpp"
#include "src/lab/compare.hpp"

namespace edgeshade::cli {

/// How settings are compared with the oracle: a map's bias is tuned unless it was typed. `scene`:
/// with the settings' casters, null for the call's own.
lab::Contender contenderOf(const std::string& name, const DrawSettings& settings,
                           std::shared_ptr<const LoadedScene> scene);

/// What the task looks at: `views` of the lab's views, or where a camera was typed and no number of
/// views, that one alone. The lab's views have lights of their own, if neither lights nor --lights
/// were typed. Throws Error(usage) for too many lights.
void lookAt(lab::CompareTask& task, const ViewOptions& view, const Scene& scene, int views,
            bool viewsTyped);

} // namespace edgeshade::cli
