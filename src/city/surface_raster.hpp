#pragma once

#include "preprocess/base/file_io.hpp"
#include "src/city/city_tile.hpp"

#include <filesystem>

namespace edgeshade::city {

/// The surface of a GeoTIFF of heights in metres, in one band of 16- or 32-bit integers or floats,
/// with square or oblong pixels along the axes: two triangles between the middles of each four
/// pixels. The outer pixels' heights reach to the raster's edge, and walls go down from there to
/// its lowest height, so that no light passes between rasters side by side. Pixels without data
/// leave holes. Safe on untrusted input. Throws InputError; Error(unavailable) if the program was
/// built without libgeotiff.
CityTile tileFromRaster(const Bytes& bytes, const std::filesystem::path& path);

} // namespace edgeshade::city
