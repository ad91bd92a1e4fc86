#pragma once

#include "preprocess/gltf/gltf_document.hpp"

namespace edgeshade {

/// Reads a .gltf with its files or a .glb. External files are taken from the asset's own folder
/// (or below it) alone, links that lead out of it not followed. Safe on untrusted input. Throws
/// InputError.
GltfDocument readGltf(const std::filesystem::path& path, const ReadingLimits& limits = {});

/// The same from bytes; `path` gives the folder of external files and the name in messages.
GltfDocument parseGltf(std::span<const std::uint8_t> bytes, const std::filesystem::path& path,
                       const ReadingLimits& limits = {});

} // namespace edgeshade
