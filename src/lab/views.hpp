#pragma once

#include "src/shadow/lights/light.hpp"
#include "src/shadow/view/frustum.hpp"

#include <string>
#include <vector>

namespace edgeshade::lab {

/// What to see and a light to compare by, and what kind of view it is.
struct LabView {
    std::string name; ///< e.g. "3: inside, point light inside"
    Frustum frustum;
    Light light;
};

/// `count` views around and inside the scene, in turn: from outside with a light above; from
/// inside with a light inside; from outside with a grazing directional light; from outside with a
/// light close to a surface; from inside with a directional light; close to a surface with a light
/// outside; twice from 1e-2, 1e-3 or 1e-4 of the scene's diagonal from a surface, with a light
/// between the two and with a directional one. The same scene and count give the same views.
/// `height`: of orthographic ones, in scene units; nothing: perspective.
std::vector<LabView> labViews(const Scene& scene, std::size_t count, double fovDegrees,
                              double aspect, std::optional<double> height = {});

} // namespace edgeshade::lab
