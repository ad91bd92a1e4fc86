#pragma once

#include "preprocess/shadow_extension.hpp"

#include <optional>

namespace edgeshade {

/// A scene on the CPU, ready for the GPU.
struct LoadedScene {
    GltfDocument document;
    Scene scene;
    std::vector<BatchShadow> shadows; ///< one a batch
    CasterSettings settings;
};

/// Reads a file, packed or not. `wanted`: what the user asked for, if anything; shadow data packed
/// with other settings are left aside and made anew, with a warning. Throws InputError.
LoadedScene loadScene(const std::filesystem::path& path,
                      const std::optional<CasterSettings>& wanted);

/// What tells the holes of a batch's caps: three vec4s a cap, one a corner of the sorted triangle,
/// (u, v, alpha of the vertex colour, 0).
std::vector<glm::vec4> capHoles(const Batch& batch, const Casters& casters, const CasterMesh& mesh);

} // namespace edgeshade
