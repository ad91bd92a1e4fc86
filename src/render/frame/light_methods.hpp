#pragma once

#include "src/render/technique/light_method.hpp"
#include "src/shadow/view/frame_view.hpp"

#include <vector>

namespace edgeshade {

struct GpuScene;
class Renderer;

/// How a renderer makes the shadows of each of the view's lights, in a prepared scene.
std::vector<LightMethod> lightMethods(const GpuScene& scene, const FrameView& view,
                                      const Renderer& renderer);

} // namespace edgeshade
