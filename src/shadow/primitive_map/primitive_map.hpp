#pragma once

#include "src/shadow/primitive_map/cutouts.hpp"
#include "src/shadow/primitive_map/light_tiles.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace edgeshade {

/// Corners of a triangle in the world.
using WorldTriangle = std::array<glm::dvec3, 3>;

/// Parameters of primitive maps.
struct PrimitiveMapSettings {
    int size = 512; ///< texels along a tile's edge; a power of 2, >= 4
    /// GPU memory of a map, or of all maps of a scene's PrimitiveMaps together. Smaller maps are
    /// tried first.
    std::size_t mostBytes = std::size_t{128} << 20;
    /// Texels with longer lists are divided in 4 x 4, and each piece again from three times the
    /// length on.
    std::size_t splitAbove = 6;
    int mostSplits = 3; ///< depth of nested divisions
    /// The longest list allowed: building stops when a longer one is found.
    std::size_t longestWanted = std::numeric_limits<std::size_t>::max();
    bool othersReceive = false; ///< some surfaces are not casters
    Box receivers; ///< everything that the light shines on, in the world; for directional lights
                   ///< with an extent
    /// The surfaces that look up, if the map needn't serve others; they outlive the building. Null:
    /// any may.
    const std::vector<WorldTriangle>* lookingUp = nullptr;
    CutoutTextures cutouts; ///< textures of casting alpha-tested triangles; empty if none of them
                            ///< cast
};

/// Places of a light with an extent that primitive_map_points.glsl counts at once.
inline constexpr std::size_t placesAtOnce = 16;

/// PrimitiveMapSettings::size for a light with an extent: the region between a texel and such a
/// light shrinks little with the texel.
inline int sizeForExtents(int size) {
    return std::max(4, size / 2);
}

/// Lists, by a light's rays, of the triangles that may shade what it sees (docs/method.md, C34);
/// read by primitive_map_lookup.glsl.
struct PrimitiveMap {
    LightTiles tiles;
    int size = 0;
    /// Header, entries and records, each from a whole texel on, so that a host can take them as one
    /// table without a copy.
    ///
    /// The header has one pair (dark behind, reference) for each of the tiles' texels, row by row
    /// and tile by tile, then blocks of 4 x 4 for the parts of divided ones. A reference is 0: no
    /// list; > 0: the start of a list among the entries, plus a half if light-facing casters need
    /// none of it; < 0: the negated start of a block.
    ///
    /// Entries are pairs, too: lists, one after another from 1 on, of (name, nearest depth of the
    /// next entry or neverDark) from near to far. A name is the record's number, or -1 - that
    /// number for an alpha-tested triangle; plus a half if light-facing casters need no later
    /// entries.
    ///
    /// Records have three texels per triangle: an edge in each xyz (Occluder::edges), the plane in
    /// the fourth components. An alpha-tested triangle has three more: CutoutPlanes' u, v, alpha,
    /// with u's fourth component naming the record of its texture: (place, size) in the atlas,
    /// (cutoff, wrap along u, along v, linear or not). The texels of a texture of its own follow
    /// its record, and the place is (their first index, 0). A tinted triangle has (1 or 0 for each
    /// edge: rays on it are its own; the record of its tint), and CutoutPlanes' u and v. A tint is
    /// (red, green, blue, -1), then as a texture; its texels are those of red, of green and of
    /// blue.
    std::vector<glm::vec4> texels;
    std::size_t headers = 0, entries = 0; ///< numbers of pairs
    bool cutouts = false;                 ///< some triangles are alpha-tested, or tinted
    /// For a light with an extent (docs/method.md, C42): records are three texels per triangle, its
    /// corners in map space, sorted by x, then y, then z.
    bool extended = false;
    std::size_t longestList = 0;
    double meanList = 0.0; ///< average entries per list

    std::size_t entriesBegin() const { return (headers + 1) / 2; } ///< first texel
    std::size_t recordsBegin() const { return entriesBegin() + (entries + 1) / 2; }
    std::size_t records() const { return texels.size() - recordsBegin(); } ///< number of texels
    std::size_t bytes() const {
        return (headers + entries) * sizeof(glm::vec2) + records() * sizeof(glm::vec4);
    }
};

/// Kind of light and tiles; the values are the shader's.
enum class PrimitiveMapKind { directional = 0, oneTile = 1, sixTiles = 2 };

inline PrimitiveMapKind kindOf(const LightTiles& tiles) {
    if (tiles.directional) return PrimitiveMapKind::directional;
    return tiles.tiles.size() == 1 ? PrimitiveMapKind::oneTile : PrimitiveMapKind::sixTiles;
}

/// Larger than any depth.
inline constexpr float neverDark = 1e30f;

/// Limit of references: a float holds these numbers exactly, with a half added.
inline constexpr std::size_t mostReferences = std::size_t{1} << 23;

} // namespace edgeshade
