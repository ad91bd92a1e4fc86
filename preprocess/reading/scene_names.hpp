#pragma once

#include "preprocess/gltf/gltf_document.hpp"

#include <string>

namespace edgeshade {

/// The name of a node or a material in the file, or "nodes[3]" without one. The material after the
/// last is the default material.
std::string nodeTitle(const GltfDocument& document, std::size_t node);
std::string materialTitle(const GltfDocument& document, std::size_t material);

} // namespace edgeshade
