#pragma once

#include "preprocess/base/warnings.hpp"
#include "preprocess/gltf/gltf_document.hpp"
#include "preprocess/scene/animation.hpp"

#include <optional>

namespace edgeshade {

/// Reads the first animation that moves nodes (glTF 2.0, 3.11); null if there is none. Channels of
/// morph weights and of extensions are left aside; a broken animation is left out with a warning
/// that names the field and its value. Safe on untrusted input.
std::optional<Animation> readAnimation(const GltfDocument& document, Warnings& warnings);

} // namespace edgeshade
