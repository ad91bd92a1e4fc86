#pragma once

#include "preprocess/base/warnings.hpp"
#include "preprocess/gltf/gltf_document.hpp"

#include <vector>

namespace edgeshade {

/// The images of texture `texture`, which must exist, best first: EXT_texture_webp's, the texture's
/// own, KHR_texture_basisu's. A reference to a missing image gets a warning, and so does a texture
/// without any image. Safe on untrusted input.
std::vector<int> sourcesOf(const GltfDocument& document, std::size_t texture, Warnings& warnings);

} // namespace edgeshade
