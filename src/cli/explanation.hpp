#pragma once

#include "src/render/frame/frame.hpp"

namespace edgeshade::cli {

/// What `render --explain` says of the frame that the renderer has just drawn.
std::string explanationOf(const Renderer& renderer, const GpuScene& scene, const FrameView& view);

} // namespace edgeshade::cli
