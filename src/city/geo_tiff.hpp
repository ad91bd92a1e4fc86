#pragma once

#include "preprocess/base/file_io.hpp"
#include "src/city/city_map.hpp"

namespace edgeshade::city {

/// Hours of sun as a GeoTIFF: one band of floats in tiles of 256 by 256, deflated, north up, with
/// the EPSG code of the plan's coordinates if there is one. Cells without a surface are -1, which
/// is declared as no data. The same map gives the same bytes. Throws Error(unavailable) if the
/// program was built without libgeotiff.
Bytes geoTiffOf(const CityMap& map, const Plan& plan);

} // namespace edgeshade::city
