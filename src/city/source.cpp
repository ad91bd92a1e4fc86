#include "src/city/source.hpp"

#include "preprocess/gltf/gltf_reading.hpp"
#include "src/city/city_json.hpp"
#include "src/city/gltf_tile.hpp"
#include "src/city/surface_raster.hpp"

#include <glm/gtc/matrix_transform.hpp>

namespace edgeshade::city {

bool staysInside(const std::filesystem::path& path) {
    const std::filesystem::path resolved = path.lexically_normal();
    return !resolved.empty() && resolved.is_relative() && *resolved.begin() != "..";
}

Bytes bytesOf(const std::filesystem::path& folder, const Source& source,
              const SourceReading& reading) {
    return readFile(folder / source.file, reading.limits.fileBytes);
}

CityTile readSource(const std::filesystem::path& folder, const Source& source, const Bytes& bytes,
                    const SourceReading& reading) {
    const std::filesystem::path path = folder / source.file;
    switch (source.kind) {
    case SourceKind::cityJson:
    case SourceKind::cityJsonSequence:
        return tileFromCityJson(bytes, path, source.kind == SourceKind::cityJsonSequence,
                                reading.lod);
    case SourceKind::gltf:
        return tileFromGltf(parseGltf(bytes, path, reading.limits), source.frameFromTile);
    case SourceKind::b3dm: {
        glm::dvec3 center(0.0);
        const std::span<const std::uint8_t> glb = glbOfB3dm(bytes, path, center);
        // The centre is in the tile's axes, z up.
        const glm::dmat4 frameFromZUp = source.frameFromTile * glm::transpose(eastNorthUpFromGltf);
        return tileFromGltf(parseGltf(glb, path, reading.limits),
                            frameFromZUp * glm::translate(glm::dmat4(1.0), center) *
                                eastNorthUpFromGltf);
    }
    case SourceKind::raster:
        return tileFromRaster(bytes, path);
    }
    return {};
}

} // namespace edgeshade::city
