#pragma once

#include "preprocess/shadow_extension.hpp"

#include <functional>
#include <optional>

namespace edgeshade {

/// A scene on the CPU, ready for the GPU.
struct LoadedScene {
    GltfDocument document;
    Scene scene;
    std::vector<BatchShadow> shadows; ///< one a batch
    CasterSettings settings;
};

/// What loading does, in this order.
enum class LoadStage { read, flatten, shadows };

/// "read", "flatten", "shadows".
const char* nameOf(LoadStage stage);

/// Reads a file, packed or not. `wanted`: what the user asked for, if anything; shadow data packed
/// with other settings are left aside and made anew, with a warning. `onStage` is called at the
/// start of each stage. Throws InputError.
LoadedScene loadScene(const std::filesystem::path& path,
                      const std::optional<CasterSettings>& wanted,
                      const std::function<void(LoadStage)>& onStage = {});

/// What tells the holes of a batch's caps: three vec4s a cap, one a corner of the sorted triangle,
/// (u, v, alpha of the vertex colour, 0).
std::vector<glm::vec4> capHoles(const Batch& batch, const Casters& casters, const CasterMesh& mesh);

} // namespace edgeshade
