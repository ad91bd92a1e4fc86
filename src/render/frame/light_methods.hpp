#pragma once

#include "src/shadow/view/frame_view.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace edgeshade {

struct GpuScene;
class Renderer;

/// How a light's shadows are made, as reports say it.
struct LightMethod {
    std::string method;    ///< as --shadows has it
    std::string rule;      ///< by which it was chosen, of ShadowPolicy
    std::string why;       ///< a clause, of a map or planes what they are; empty: it was asked for
    double buildMs = 0.0;  ///< of its primitive map or the scene's planes, on the CPU
    std::size_t bytes = 0; ///< of shadow maps once they were drawn, which lights of a kind share
};

/// How a renderer makes the shadows of each of the view's lights, in a scene that is prepared.
std::vector<LightMethod> lightMethods(const GpuScene& scene, const FrameView& view,
                                      const Renderer& renderer);

} // namespace edgeshade
