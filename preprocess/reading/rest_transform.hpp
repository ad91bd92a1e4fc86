#pragma once

#include "preprocess/gltf/tinygltf_fwd.hpp"
#include "preprocess/scene/node_transform.hpp"

#include <optional>

namespace edgeshade {

/// The node's transform at rest; its matrix, if it has one, is not looked at.
NodeTransform restTransform(const tinygltf::Node& node);

/// Whether a matrix places the node.
bool hasMatrix(const tinygltf::Node& node);

/// Where the node is in its parent at rest, however the file says it.
glm::dmat4 restMatrix(const tinygltf::Node& node);

/// The same as if it did not scale by 0, as far as that can be told.
glm::dmat4 unflattenedRestMatrix(const tinygltf::Node& node);

/// The translation, rotation and scale, none of them 0 or negative, that make a matrix; null where
/// none do.
std::optional<NodeTransform> partsOf(const glm::dmat4& matrix);

} // namespace edgeshade
