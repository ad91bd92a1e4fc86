#pragma once

#include "src/render/volumes/render_settings.hpp"
#include "src/scene/gpu_scene.hpp"
#include "src/shadow/geometry/frame_view.hpp"

namespace edgeshade {

/// Makes and uploads what the view's lights need of a scene beyond its records: groups of casters
/// that a stencil can count, and primitive maps. Kept while lights and casters rest. Throws
/// Error(unavailable) if the GL can't.
void prepareScene(GpuScene& scene, const LoadedScene& loaded, const FrameView& view,
                  const RenderSettings& settings, const gl::Capabilities& capabilities);

} // namespace edgeshade
