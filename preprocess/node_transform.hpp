#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <tiny_gltf.h>

namespace edgeshade {

/// What places a node in its parent (glTF 2.0, 3.5.3).
struct NodeTransform {
    glm::dvec3 translation{0.0};
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0}; ///< (w, x, y, z)
    glm::dvec3 scale{1.0};

    /// parentFromNode: scaled, then turned, then moved.
    glm::dmat4 matrix() const;
};

/// The node's transform at rest; its matrix, if it has one, is not looked at.
NodeTransform restTransform(const tinygltf::Node& node);

/// Whether a matrix places the node.
bool hasMatrix(const tinygltf::Node& node);

/// Where the node is in its parent at rest, however the file says it.
glm::dmat4 restMatrix(const tinygltf::Node& node);

} // namespace edgeshade
