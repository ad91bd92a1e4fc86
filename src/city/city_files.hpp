#pragma once

#include "src/city/city_map.hpp"
#include "src/image/image.hpp"

#include <functional>

namespace edgeshade::city {

/// A table of all objects with cells as CSV (RFC 4180, lines end with LF): id, building, source,
/// cells, area_m2 seen from above, and the mean, least and largest hours of their cells.
std::string objectsCsvOf(const CityMap& map, const Plan& plan);

/// {"jobs", "cells", "cells_with_surface", "grid", "epsg", "place", "positions", "hours" {"min",
/// "mean", "max"}, "by_surface" {kind {"cells", "mean_hours"}}, "buildings", "objects", "sources"}.
nlohmann::ordered_json mapReportOf(const CityMap& map, const Plan& plan);

/// The map as a picture of at most 1024 pixels a side, north up, one cell for each pixel; clear
/// where there is no surface. `color`: 0xRRGGBB of a share of the most hours.
Image previewOf(const CityMap& map, const std::function<std::uint32_t(double share)>& color);

/// A CityJSON source with the attributes "+sun-hours" (mean), "+sun-hours-min" and
/// "+sun-hours-max" of each object with cells. `source`: in the plan. Throws InputError.
std::string cityJsonWithHours(const CityMap& map, const Plan& plan, std::size_t source);

} // namespace edgeshade::city
