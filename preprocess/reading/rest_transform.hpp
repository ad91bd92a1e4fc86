#pragma once

#include "preprocess/gltf/tinygltf_fwd.hpp"
#include "preprocess/scene/node_transform.hpp"

#include <optional>

namespace edgeshade {

/// The node's transform at rest from its properties; a matrix is ignored.
NodeTransform restTransform(const tinygltf::Node& node);

/// Whether the node has a matrix.
bool hasMatrix(const tinygltf::Node& node);

/// The matrix of a node at rest, relative to its parent, from its matrix or its properties.
glm::dmat4 restMatrix(const tinygltf::Node& node);

/// The same matrix as if the node did not scale by 0, as far as that can be known.
glm::dmat4 unflattenedRestMatrix(const tinygltf::Node& node);

/// The translation, rotation and scale that compose a matrix, with no scale of 0 or below; null if
/// there are none.
std::optional<NodeTransform> partsOf(const glm::dmat4& matrix);

} // namespace edgeshade
