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

/// The sources in a folder, those that a .txt lists, or the one that `input` is: .json and .jsonl
/// (CityJSON), .glb and .gltf, .tif and .tiff. A folder with a tileset.json is that tileset;
/// folders below are left alone. A list has a path a line, in the list's folder or below; lines
/// that are empty or begin with # are left out. Throws InputError if there is none, and naming the
/// line of a list.
SourceList sourcesIn(const std::filesystem::path& input, const ReadingLimits& limits);

} // namespace edgeshade::city
