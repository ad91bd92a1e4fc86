#pragma once

#include "preprocess/gltf/gltf_document.hpp"

namespace edgeshade {

/// Reads a .gltf with its files or a .glb. External files must be in the asset's own folder or
/// below it; links that lead out of it are not followed. Safe on untrusted input. Throws
/// InputError.
GltfDocument readGltf(const std::filesystem::path& path, const ReadingLimits& limits = {});

/// As readGltf(), from bytes; `path` gives the folder of external files and the name in messages.
GltfDocument parseGltf(std::span<const std::uint8_t> bytes, const std::filesystem::path& path,
                       const ReadingLimits& limits = {});

} // namespace edgeshade
