#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace edgeshade {

/// What places a node in its parent (glTF 2.0, 3.5.3).
struct NodeTransform {
    glm::dvec3 translation{0.0};
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0}; ///< (w, x, y, z)
    glm::dvec3 scale{1.0};

    /// parentFromNode: scaled, then turned, then moved.
    glm::dmat4 matrix() const;
};

} // namespace edgeshade
