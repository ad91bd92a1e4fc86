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

/// Texture coordinates for the caps of a batch whose casters have holes: two vec4s a cap, (A, B)
/// and (C, 0), in the order of the sorted triangle.
std::vector<glm::vec4> capTexcoords(const Batch& batch, const Casters& casters,
                                    const CasterMesh& mesh);

} // namespace edgeshade
