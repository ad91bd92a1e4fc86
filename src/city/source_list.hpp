#pragma once

#include "src/city/source.hpp"
#include "src/sun/place.hpp"

#include <vector>

namespace edgeshade::city {

struct SourceList {
    std::filesystem::path folder;
    std::vector<Source> sources;     ///< by name
    std::optional<sun::Place> place; ///< of an earth-centred tileset
};

/// The sources in a folder, or the one that `input` is: .json and .jsonl (CityJSON), .glb and
/// .gltf, .tif and .tiff. A folder with a tileset.json is that tileset; folders below are left
/// alone. Throws InputError if there is none.
SourceList sourcesIn(const std::filesystem::path& input, const ReadingLimits& limits);

} // namespace edgeshade::city
