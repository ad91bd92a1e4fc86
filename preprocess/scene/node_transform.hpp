#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <optional>

namespace edgeshade {

/// Transform of a node relative to its parent (glTF 2.0, 3.5.3).
struct NodeTransform {
    glm::dvec3 translation{0.0};
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0}; ///< (w, x, y, z)
    glm::dvec3 scale{1.0};

    /// parentFromNode: scale, then rotation, then translation.
    glm::dmat4 matrix() const;
    /// matrix(), with scales of 0 replaced by 1.
    glm::dmat4 unflattened() const;
};

/// The matrix with one zero column replaced by the direction that the two others leave. With more
/// zero columns nothing determines them, and they stay.
glm::dmat4 unflattened(const glm::dmat4& parentFromNode);

/// The place of a node relative to its nearest animated ancestor, itself included, or to the world.
struct NodePlace {
    int animatedNode = -1;            ///< -1: none, the node is static
    glm::dmat4 animatedFromNode{1.0}; ///< worldFromNode if the node is static
    glm::dmat4 unflattened{1.0};      ///< animatedFromNode as if no node scaled by 0, for lights
                                      ///< and cameras
};

/// The transformed origin; null if it is farther away than farthestPlace, or NaN.
std::optional<glm::dvec3> originOf(const glm::dmat4& transform);

/// The rotation of a transform without scale, mirroring and shear: -z keeps its direction, and y
/// stays as close to its own as it can. Null if it has none, because it is scaled to nothing or not
/// finite.
std::optional<glm::dmat3> turnOf(const glm::dmat4& transform);

/// As above if a node may scale by 0: directions that vanish are taken from `unflattened`, which is
/// the transform as if no node did.
std::optional<glm::dmat3> turnOf(const glm::dmat4& transform, const glm::dmat4& unflattened);

/// The direction of -z under such a transform, of length 1. Null if neither determines it.
std::optional<glm::dvec3> forwardOf(const glm::dmat4& transform, const glm::dmat4& unflattened);

} // namespace edgeshade
