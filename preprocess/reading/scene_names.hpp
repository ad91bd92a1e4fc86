#pragma once

#include "preprocess/gltf/gltf_document.hpp"

#include <string>

namespace edgeshade {

/// The name of a node, or a material, in the file; of one without a name "nodes[3]". The material
/// behind the last one is the default material.
std::string nodeTitle(const GltfDocument& document, std::size_t node);
std::string materialTitle(const GltfDocument& document, std::size_t material);

} // namespace edgeshade
