#pragma once

#include "src/city/city_tile.hpp"
#include "src/sun/place.hpp"

#include <filesystem>

namespace edgeshade::city {

/// A city drawn in code: hills, streets on a grid, gabled houses, courtyards and towers.
struct GeneratedCity {
    std::uint32_t seed = 1;
    int tiles = 4;       ///< along a side
    int blocks = 2;      ///< along a tile's side; a block is 32 m with its streets
    double hills = 20.0; ///< metres between valleys and tops, about; 0: flat
    glm::dvec3 corner{691200.0, 5334016.0, 512.0}; ///< of the south-west, in its coordinates
    /// Houses, each a grid of that many by that many roofs: multiplies triangles, not heights.
    int roofs = 1;

    double side() const { return 32.0 * blocks * tiles; } ///< metres

    // The same city in several formats. All coordinates are multiples of 1/8 m, which every format
    // holds exactly. Files are written into `folder`, which must exist.

    /// CityJSON 2.0: tile-X-Y.city.json each, or one city.city.json. Buildings are solids with
    /// semantics, courtyards have holes.
    void writeCityJson(const std::filesystem::path& folder, bool inOneFile = false) const;
    /// The same as a CityJSONSeq, city.city.jsonl.
    void writeCityJsonSequence(const std::filesystem::path& folder) const;
    /// tile-X-Y.glb each, relative to the city's corner.
    void writeGltf(const std::filesystem::path& folder) const;
    /// 3D Tiles: a tileset.json, and tiles as .glb, or .b3dm where X + Y is odd. The city's corner
    /// is at `place`.
    void writeTileset(const std::filesystem::path& folder, const sun::Place& place) const;
    /// The highest surfaces as GeoTIFFs of pixels of that width: surface-K.tif, from west to east,
    /// K from 1 to `parts`, which divides the pixels of a row.
    void writeRaster(const std::filesystem::path& folder, double pixel, unsigned parts = 1) const;

    std::size_t triangles() const; ///< of glTF, all tiles
};

} // namespace edgeshade::city
