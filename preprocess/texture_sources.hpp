#pragma once

#include "preprocess/gltf_document.hpp"
#include "preprocess/warnings.hpp"

#include <vector>

namespace edgeshade {

/// The images of texture `texture`, which must exist, best first: EXT_texture_webp's, the texture's
/// own, KHR_texture_basisu's. What names no image becomes a warning, and so does a texture without
/// any. Safe on untrusted input.
std::vector<int> sourcesOf(const GltfDocument& document, std::size_t texture, Warnings& warnings);

} // namespace edgeshade
