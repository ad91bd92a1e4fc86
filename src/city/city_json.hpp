#pragma once

#include "preprocess/base/file_io.hpp"
#include "src/city/city_tile.hpp"

#include <filesystem>
#include <optional>

namespace edgeshade::city {

/// Reads CityJSON 1.1 or 2.0, or with `isSequence` CityJSONSeq, one JSON object a line. Each object
/// gives the geometry of the highest level of detail that isn't above `lod`; null: the highest. An
/// object without one is left out with a warning, and so are geometry templates. Parts of a
/// building belong to the building. Safe on untrusted input. Throws InputError naming the field.
CityTile tileFromCityJson(const Bytes& bytes, const std::filesystem::path& path, bool isSequence,
                          std::optional<double> lod);

} // namespace edgeshade::city
