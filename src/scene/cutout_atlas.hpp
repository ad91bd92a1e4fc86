#pragma once

#include "src/scene/load.hpp"
#include "src/shadow/primitive_map/cutouts.hpp"

#include <cstdint>
#include <vector>

namespace edgeshade {

/// The alpha of all textures that cut out a scene's MASK materials, in one picture.
struct CutoutAtlas {
    int width = 1, height = 1;
    std::vector<std::uint8_t> alpha; ///< rows from the top
    CutoutTextures textures;         ///< one per material of the scene
};

/// At most `largest` texels along an edge: if the textures don't fit, all are halved, as often as
/// needed. Throws InputError.
CutoutAtlas cutoutAtlasOf(const LoadedScene& loaded, int largest);

} // namespace edgeshade
