#pragma once

#include "src/render/frame/frame.hpp"
#include "src/render/frame/prepare_scene.hpp"

namespace edgeshade {

/// lightMethods() with the bytes of shadow maps that the renderer has drawn, lights of a kind take
/// turns with one, and with whose visible points were asked in its last frame.
std::vector<LightMethod> lightMethods(const GpuScene& scene, const FrameView& view,
                                      const Renderer& renderer);

} // namespace edgeshade
