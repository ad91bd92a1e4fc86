#pragma once

#include "src/scene/load.hpp"
#include "src/shadow/primitive_map/cutouts.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace edgeshade {

/// The alpha of all textures that a scene's MASK materials are cut out by, in one picture.
struct CutoutAtlas {
    int width = 1, height = 1;
    std::vector<std::uint8_t> alpha; ///< rows from the top
    CutoutTextures textures;         ///< one a material of the scene
};

/// Nothing where it would be larger than `largest` along an edge. Throws InputError.
std::optional<CutoutAtlas> cutoutAtlasOf(const LoadedScene& loaded, int largest);

} // namespace edgeshade
