#pragma once

#include "src/render/frame/frame.hpp"

namespace edgeshade::cli {

/// The text of `render --explain` for the frame that the renderer has just drawn.
std::string explanationOf(const Renderer& renderer, const GpuScene& scene, const FrameView& view);

} // namespace edgeshade::cli
