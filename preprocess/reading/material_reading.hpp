#pragma once

#include "preprocess/gltf/gltf_document.hpp"
#include "preprocess/scene/material.hpp"

namespace edgeshade {

/// All materials of the document; the default material stands at the end, and a primitive without
/// a material uses it. Throws InputError.
std::vector<Material> readMaterials(const GltfDocument& document);

} // namespace edgeshade
