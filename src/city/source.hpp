#pragma once

#include "preprocess/base/file_io.hpp"
#include "preprocess/base/limits.hpp"
#include "src/city/city_tile.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace edgeshade::city {

enum class SourceKind { cityJson, cityJsonSequence, gltf, b3dm, raster };

/// A file with a part of the city.
struct Source {
    std::string file; ///< relative to the folder, with '/'
    SourceKind kind = SourceKind::cityJson;
    glm::dmat4 frameFromTile{1.0}; ///< of glTF content, from glTF's own axes
};

/// The words of a plan for kinds, in their order.
inline constexpr const char* sourceKindNames[] = {"cityjson", "cityjsonseq", "gltf", "b3dm",
                                                  "raster"};

/// Whether a path is relative and, with "." and ".." resolved, doesn't leave its folder.
bool staysInside(const std::filesystem::path& path);

struct SourceReading {
    std::optional<double> lod; ///< of CityJSON, the most; null: the highest there is
    ReadingLimits limits;
};

/// The file's bytes, of which a plan keeps the hash.
Bytes bytesOf(const std::filesystem::path& folder, const Source& source,
              const SourceReading& reading);

/// The source's triangles from its bytes. Throws InputError; Error(unavailable) for rasters, if the
/// program was built without libgeotiff.
CityTile readSource(const std::filesystem::path& folder, const Source& source, const Bytes& bytes,
                    const SourceReading& reading);

} // namespace edgeshade::city
