#pragma once

#include "src/shadow/lights/light.hpp"
#include "src/shadow/view/frustum.hpp"

#include <string>
#include <vector>

namespace edgeshade::lab {

/// A view and lights for a comparison, with a name for its kind.
struct LabView {
    std::string name; ///< e.g. "3: inside, point light inside"
    Frustum frustum;
    Light light;
};

/// `count` views around and inside the scene, in turn:
/// - from outside with a light above;
/// - from inside with a light inside;
/// - from outside with a grazing directional light;
/// - from outside with a light close to a surface;
/// - from inside with a directional light;
/// - close to a surface with a light outside;
/// - twice at 1e-2, 1e-3 or 1e-4 of the scene's diagonal from a surface, with a light in between
///   and with a directional one.
///
/// The same scene and count give the same views. `height`: of orthographic views, in scene units;
/// null: perspective.
std::vector<LabView> labViews(const Scene& scene, std::size_t count, double fovDegrees,
                              double aspect, std::optional<double> height = {});

} // namespace edgeshade::lab
