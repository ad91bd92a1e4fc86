#pragma once

#include "preprocess/scene/scene.hpp"

#include <glm/glm.hpp>

namespace edgeshade {

/// A perspective camera in the world: right-handed, +Y up. If it looks straight up or down, -Z is
/// up in the picture.
struct Camera {
    glm::dvec3 from{0.0, 0.0, 1.0};
    glm::dvec3 to{0.0};
    double fovDegrees = 45.0; ///< vertical, 0 < fov < 180
};

/// World to camera space (x right, y up, looking along -z).
glm::dmat4 viewFromWorld(const Camera& camera);

/// Half the picture's height at unit depth.
double tangentOfHalfFov(double fovDegrees);

/// The default direction from a scene to the eye: from slightly above.
glm::dvec3 framingDirection();

/// A camera that sees the whole box from framingDirection(), around which measured views are laid;
/// for pictures see framing.hpp.
Camera framingCamera(const Box& box, double fovDegrees, double aspect);

/// A camera that sees the whole box from `direction`, which points from the box to the eye.
Camera framingCamera(const Box& box, double fovDegrees, double aspect, const glm::dvec3& direction);

} // namespace edgeshade
