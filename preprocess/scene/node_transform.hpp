#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <optional>

namespace edgeshade {

/// What places a node in its parent (glTF 2.0, 3.5.3).
struct NodeTransform {
    glm::dvec3 translation{0.0};
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0}; ///< (w, x, y, z)
    glm::dvec3 scale{1.0};

    /// parentFromNode: scaled, then turned, then moved.
    glm::dmat4 matrix() const;
};

/// The turn in a transform of finite numbers, without its scale, mirroring and shear: -z stays
/// where it points, and y as near to that as it can. Null where it has none, scaled to nothing.
std::optional<glm::dmat3> turnOf(const glm::dmat4& transform);

} // namespace edgeshade
