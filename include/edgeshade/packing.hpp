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
    double weldTolerance = 0.0; ///< scene units: vertices nearer to each other become one
    bool autoWeld = false; ///< the weld tolerance is chosen for the scene; weldTolerance is ignored
    double casterError = 0.0; ///< scene units: coarser casters, off by so much at most
    double flatTolerance =
        0.0; ///< degrees, below 45: edges within nearly flat patches cast nothing
};

/// A scene with its shadow data.
struct PackedScene {
    std::vector<std::uint8_t> glb; ///< a whole GLB, which any viewer opens
    std::size_t triangles = 0;     ///< of all surfaces
    std::size_t casterTriangles = 0;
    std::size_t edges = 0;
    double diagonal = 0.0; ///< of the scene's bounds, scene units
    std::vector<std::string> warnings;
};

/// Packs a glTF file, .gltf or .glb, as `edgeshade pack` does: the same bytes. Throws
/// std::runtime_error with a sentence that names file, field and value.
PackedScene packScene(const std::filesystem::path& file, const PackSettings& settings = {});

} // namespace edgeshade
