#pragma once

#include "src/scene/load.hpp"
#include "src/shadow/primitive_map/cutouts.hpp"

#include <cstdint>
#include <vector>

namespace edgeshade {

/// The alpha of all textures that a scene's MASK materials are cut out by, in one picture.
struct CutoutAtlas {
    int width = 1, height = 1;
    std::vector<std::uint8_t> alpha; ///< rows from the top
    CutoutTextures textures;         ///< one a material of the scene
};

/// At most `largest` texels along an edge: of textures that don't fit together, all are taken at
/// half their size, and so on. Throws InputError.
CutoutAtlas cutoutAtlasOf(const LoadedScene& loaded, int largest);

} // namespace edgeshade
