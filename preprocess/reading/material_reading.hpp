#pragma once

#include "preprocess/gltf/gltf_document.hpp"
#include "preprocess/scene/material.hpp"

namespace edgeshade {

/// All materials of the document. The default material is last, for primitives without a material.
/// Broken optional parts are left out with a warning. Throws InputError.
std::vector<Material> readMaterials(const GltfDocument& document, Warnings& warnings);

} // namespace edgeshade
