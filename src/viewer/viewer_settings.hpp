#pragma once

#include "src/render/volumes/render_settings.hpp"
#include "src/scene/primitive_map_worker.hpp"
#include "src/shadow/view/frame_view.hpp"

#include <memory>
#include <optional>

namespace edgeshade::viewer {

/// Settings of a viewer that its state can't change.
struct ViewerSettings {
    RenderSettings render;             ///< fields of SideSettings, `ambient` and `layout` are
                                       ///< ignored
    std::optional<SidesLayout> layout; ///< empty: the best that the context has
    DepthChoice depth;
    /// Builds primitive maps that aren't needed at once; null: the viewer builds them.
    std::shared_ptr<PrimitiveMapWorker> mapWorker;
    /// chooseLights(), if the window provides it; null: all lights are drawn with shadows.
    void (*chooseLights)(FrameView&, std::optional<std::size_t>) = nullptr;
};

} // namespace edgeshade::viewer
