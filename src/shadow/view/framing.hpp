#pragma once

#include "src/shadow/view/camera.hpp"

namespace edgeshade {

/// The nearest camera from `direction` that shows all vertices of the scene with a small margin.
/// They touch the margin left and right, or above and below, or on all four sides. All of them are
/// in front of the eye by at least a fiftieth of the scene's diagonal. The camera looks at the
/// depth of the scene's middle. Takes time linear in the vertices.
Camera framingCamera(const Scene& scene, double fovDegrees, double aspect,
                     const glm::dvec3& direction = framingDirection());

} // namespace edgeshade
