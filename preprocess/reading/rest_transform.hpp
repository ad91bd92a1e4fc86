#pragma once

#include "preprocess/gltf/tinygltf_fwd.hpp"
#include "preprocess/scene/node_transform.hpp"

namespace edgeshade {

/// The node's transform at rest; its matrix, if it has one, is not looked at.
NodeTransform restTransform(const tinygltf::Node& node);

/// Whether a matrix places the node.
bool hasMatrix(const tinygltf::Node& node);

/// Where the node is in its parent at rest, however the file says it.
glm::dmat4 restMatrix(const tinygltf::Node& node);

} // namespace edgeshade
