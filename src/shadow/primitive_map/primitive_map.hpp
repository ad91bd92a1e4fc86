#pragma once

#include "src/shadow/primitive_map/cutouts.hpp"
#include "src/shadow/primitive_map/light_tiles.hpp"

#include <cstddef>
#include <limits>
#include <vector>

namespace edgeshade {

/// How primitive maps are made.
struct PrimitiveMapSettings {
    int size = 512; ///< texels along a tile's edge; a power of 2, >= 4
    /// On the GPU, of a map; of a scene's PrimitiveMaps all of them together. Smaller maps are
    /// tried first.
    std::size_t mostBytes = std::size_t{128} << 20;
    std::size_t splitAbove = 8; ///< texels whose points have more to test are divided in 4 x 4
    int mostSplits = 3;         ///< one in another
    /// A map with a longer list is not wanted: building ends where one is found.
    std::size_t longestWanted = std::numeric_limits<std::size_t>::max();
    bool othersReceive = false; ///< some surfaces are no casters
    Box receivers; ///< all that the light shines on, in the world: of directional lights with
                   ///< extent
    CutoutTextures cutouts; ///< where alpha-tested ones cast; else none of them may be there
};

/// Lists of the triangles that may shade what a light sees, by its rays (docs/method.md, C34); what
/// primitive_map_lookup.glsl reads. All three are textures of floats in rows of `columns` texels.
struct PrimitiveMap {
    LightTiles tiles;
    int size = 0;
    /// A texel (dark behind, reference) for each of the tiles' texels, row by row and tile by tile,
    /// then blocks of 4 x 4 for the parts of those that were divided. A reference is 0: no list; >
    /// 0: where a list begins in `entries`, and a half more if light-facing casters need none of
    /// it; < 0: negated, where a block begins.
    std::vector<glm::vec2> header;
    /// Lists, one after the other from 1 on, of (name, nearest depth of the next one or neverDark)
    /// from near to far. A name is the record's number or, of an alpha-tested one, -1 - that
    /// number; and a half more if light-facing casters need none behind it.
    std::vector<glm::vec2> entries;
    /// Three texels a triangle: in xyz an edge each (Occluder::edges), in the fourth components the
    /// plane. Of an
    /// alpha-tested one three more: CutoutPlanes' u, v, alpha, and with u the record that says what
    /// it is cut out by: (place, size) in the atlas, (cutoff, wrap along u, along v, linear or
    /// not).
    std::vector<glm::vec4> records;
    bool cutouts = false; ///< some are alpha-tested
    /// Of a light with an extent (docs/method.md, C42): records are three texels a triangle, its
    /// corners in map space, those that are before others by x, y and z first.
    bool extended = false;
    std::size_t longestList = 0;
    double meanList = 0.0; ///< entries of a list, on the average

    std::size_t bytes() const {
        return header.size() * sizeof(glm::vec2) + entries.size() * sizeof(glm::vec2) +
               records.size() * sizeof(glm::vec4);
    }
};

/// How a map's light and tiles are; the values are the shader's.
enum class PrimitiveMapKind { directional = 0, oneTile = 1, sixTiles = 2 };

inline PrimitiveMapKind kindOf(const LightTiles& tiles) {
    if (tiles.directional) return PrimitiveMapKind::directional;
    return tiles.tiles.size() == 1 ? PrimitiveMapKind::oneTile : PrimitiveMapKind::sixTiles;
}

/// Beyond any depth.
inline constexpr float neverDark = 1e30f;

/// Numbers that a float holds exactly together with a half, so what references can name.
inline constexpr std::size_t mostReferences = std::size_t{1} << 23;

} // namespace edgeshade
