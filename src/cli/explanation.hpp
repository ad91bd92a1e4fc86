#pragma once

#include "src/render/frame/frame.hpp"

#include <string>

namespace edgeshade::cli {

/// What a frame draws for its shadows, how, and why, in lines of text, the last one without
/// its end. `groups`: as the renderer
/// gets them.
std::string explanationOf(const LoadedScene& loaded, const FrameView& view,
                          const RenderSettings& settings, const OverflowGroups& groups,
                          const gl::Capabilities& capabilities);

} // namespace edgeshade::cli
