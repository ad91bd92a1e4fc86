#pragma once

#include "src/shadow/view/camera.hpp"

namespace edgeshade {

/// The nearest camera from `direction` that shows all vertices of the scene with a small margin
/// around them: their picture touches it left and right, or above and below, or all four where they
/// fit it. All of them are before the eye by a fiftieth of the scene's diagonal at least. It looks
/// at the depth of the scene's middle. Takes time linear in the vertices.
Camera framingCamera(const Scene& scene, double fovDegrees, double aspect,
                     const glm::dvec3& direction = framingDirection());

} // namespace edgeshade
