#pragma once

#include "preprocess/packing/shadow_extension.hpp"
#include "tests/support/gltf_builder.hpp"

#include <filesystem>
#include <vector>

namespace edgeshade::test {

inline constexpr Encoding everyEncoding[] = {Encoding::expanded, Encoding::indexed, Encoding::none};

/// Packs an asset as `pack` does. External files are taken from `path`'s folder.
Bytes packed(const Bytes& asset, Encoding encoding, const CasterSettings& settings = {},
             const std::filesystem::path& path = "test.glb");

/// The same, with warnings.
struct Packed {
    Bytes glb;
    std::vector<std::string> warnings;
};
Packed packedWithWarnings(const Bytes& asset, Encoding encoding,
                          const CasterSettings& settings = {},
                          const std::filesystem::path& path = "test.glb");

/// The shadow data that a renderer gets from a packed file.
Shadows readBack(const Bytes& packedAsset);

/// The shadow data built from an asset that isn't packed.
Shadows built(const Bytes& asset, const CasterSettings& settings = {});

/// Expects equal numbers of batches, groups and records, and identical bits in the records.
void expectSameShadows(const Shadows& actual, const Shadows& expected);

/// A scene with everything that affects shadow data: static and animated nodes, an edge with seven
/// triangles, open and closed pieces, a degenerate triangle, MASK and BLEND surfaces, a batch
/// without casters.
GltfBuilder variedScene();

} // namespace edgeshade::test
