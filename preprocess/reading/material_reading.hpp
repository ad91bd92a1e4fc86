#pragma once

#include "preprocess/gltf/gltf_document.hpp"
#include "preprocess/scene/material.hpp"

namespace edgeshade {

/// All materials of the document; the default material stands at the end, and a primitive without
/// a material uses it. What surfaces can be drawn without is left out where it is broken, with a
/// warning. Throws InputError.
std::vector<Material> readMaterials(const GltfDocument& document, Warnings& warnings);

} // namespace edgeshade
