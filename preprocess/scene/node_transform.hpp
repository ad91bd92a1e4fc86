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
    /// The same where a scale of 0 is 1.
    glm::dmat4 unflattened() const;
};

/// The same of a matrix: a column of zeros is what the two others leave. Where there are more of
/// them nothing tells them apart, and they stay.
glm::dmat4 unflattened(const glm::dmat4& parentFromNode);

/// Where a node hangs that places something: on the nearest animated node on the way to the root,
/// itself included, or on the world.
struct NodePlace {
    int animatedNode = -1;            ///< -1: none, it is static
    glm::dmat4 animatedFromNode{1.0}; ///< worldFromNode if it is static
    glm::dmat4 unflattened{1.0};      ///< the same as if no node scaled by 0; lights' and cameras'
};

/// Where the transform puts the origin; null if that is farther away than farthestPlace, or NaN.
std::optional<glm::dvec3> originOf(const glm::dmat4& transform);

/// The turn in a transform, without its scale, mirroring and shear: -z stays where it points, and y
/// as near to that as it can. Null where it has none, scaled to nothing, or where a number is not
/// finite.
std::optional<glm::dmat3> turnOf(const glm::dmat4& transform);

/// The same where some node may scale by 0: what that leaves nothing of is turned as in
/// `unflattened`, the transform as if none did.
std::optional<glm::dmat3> turnOf(const glm::dmat4& transform, const glm::dmat4& unflattened);

/// Where such a transform points -z, of length 1. Null where neither tells.
std::optional<glm::dvec3> forwardOf(const glm::dmat4& transform, const glm::dmat4& unflattened);

} // namespace edgeshade
