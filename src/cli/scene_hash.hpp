#pragma once

#include "preprocess/scene/scene.hpp"

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

namespace edgeshade {
struct GltfDocument;
}

namespace edgeshade::cli {

/// A hash of all triangles and their positions: 64-bit FNV-1a, 16 digits.
std::string hashOf(const Scene& scene);

/// [{"name", "sha256"}]: the scene's file and the buffers and images that it names, by their names
/// there, as they are on disk. Images that can't be read are left out, as from the picture.
/// `mostBytes`: of a file. Throws InputError.
nlohmann::ordered_json filesJson(const GltfDocument& document, std::uint64_t mostBytes);

} // namespace edgeshade::cli
