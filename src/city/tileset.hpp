#pragma once

#include "src/city/source.hpp"
#include "src/sun/place.hpp"

#include <vector>

namespace edgeshade::city {

/// The finest content of a tileset (3D Tiles 1.0 or 1.1).
struct Tileset {
    std::vector<Source> sources;
    /// Where the frame's origin is, if the tileset is earth-centred; null: it is in metres east,
    /// north and up already.
    std::optional<sun::Place> place;
};

/// Finds the content with the most detail: of tiles without children, and of those that children
/// add to. Tilesets within tilesets are read too. The frame of an earth-centred tileset is that of
/// metres east, north and up at its root's transform, or at the middle of its bounding volume.
/// Throws InputError for implicit tiling and for content that is neither glTF nor b3dm.
Tileset readTileset(const std::filesystem::path& folder, const std::string& file,
                    const ReadingLimits& limits);

} // namespace edgeshade::city
