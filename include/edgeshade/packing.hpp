#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace edgeshade {

/// How casters are found and stored; the defaults are those of `edgeshade pack`.
struct PackSettings {
    bool castMasked = false;    ///< MASK and BLEND surfaces cast too
    double weldTolerance = 0.0; ///< scene units: vertices closer to each other are welded
    bool autoWeld = false;      ///< choose the weld tolerance for the scene, ignoring weldTolerance
    double casterError = 0.0;   ///< scene units: the most by which simplified casters may deviate
    double flatTolerance =
        0.0; ///< degrees, below 45: edges within nearly flat patches cast nothing
};

/// A scene with its shadow data.
struct PackedScene {
    std::vector<std::uint8_t> glb; ///< a whole GLB, which any viewer opens
    std::size_t triangles = 0;     ///< of all surfaces, casting or not
    std::size_t casterTriangles = 0;
    std::size_t edges = 0;
    double diagonal = 0.0; ///< diagonal of the scene's bounds, scene units
    std::vector<std::string> warnings;
};

/// Packs a glTF file, .gltf or .glb, and returns the same bytes as `edgeshade pack` writes. Throws
/// std::runtime_error with a sentence that names file, field and value.
PackedScene packScene(const std::filesystem::path& file, const PackSettings& settings = {});

} // namespace edgeshade
