#pragma once

#include "preprocess/scene/scene.hpp"

#include <glm/glm.hpp>

namespace edgeshade {

/// A perspective camera in the world: right-handed, +Y up; where it looks straight up or down, -Z
/// is up in the picture.
struct Camera {
    glm::dvec3 from{0.0, 0.0, 1.0};
    glm::dvec3 to{0.0};
    double fovDegrees = 45.0; ///< vertical, 0 < fov < 180
};

/// World to camera space (x right, y up, looking along -z).
glm::dmat4 viewFromWorld(const Camera& camera);

/// Camera to clip space with the far plane at infinity: a direction's z equals its w bit for bit.
/// `aspect`: width over height; `near` > 0.
glm::dmat4 clipFromView(const Camera& camera, double aspect, double near);

/// A camera that sees the whole box from slightly above.
Camera framingCamera(const Box& box, double fovDegrees, double aspect);

/// A camera that sees the whole box from `direction`, which points from the box to the eye.
Camera framingCamera(const Box& box, double fovDegrees, double aspect, const glm::dvec3& direction);

} // namespace edgeshade
