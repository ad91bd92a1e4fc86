#pragma once

#include "src/city/city_hours.hpp"
#include "src/image/image.hpp"

#include <functional>
#include <span>

namespace edgeshade::city {

/// The first row of a table of objects, as CSV (RFC 4180, lines end with LF). Areas are seen from
/// above; hours are the mean, least and largest of an object's cells.
inline constexpr std::string_view objectsHeader =
    "id,building,source,cells,area_m2,mean_hours,min_hours,max_hours\n";

/// A row for each object.
std::string objectRowsOf(std::span<const ObjectHours> objects, const Plan& plan);

/// {"jobs", "sources", "cells", "cells_with_surface", "cells_held", "grid", "epsg", "place",
/// "north", "positions", "hours" {"min", "mean", "max"}, "by_surface" {kind {"cells",
/// "mean_hours"}}, "objects", "buildings"}.
nlohmann::ordered_json mapReportOf(const CityHours& hours, const Plan& plan);

/// A map as a picture of at most 1024 pixels a side, north up, one cell for each pixel; clear where
/// there is no surface. Holds these cells.
class Preview {
  public:
    explicit Preview(const CellRange& region);

    /// Adds the next row from the north: the number of sun positions that light each cell.
    void add(std::span<const std::int32_t> lit);
    /// The picture after the last row. `most`: the largest number; `color`: 0xRRGGBB of a share of
    /// it.
    Image image(std::int32_t most, const std::function<std::uint32_t(double share)>& color) const;

  private:
    std::int64_t columns_, rows_, step_;
    std::int64_t next_ = 0; ///< the row that comes next
    std::vector<std::int32_t> lit_;
};

/// A CityJSON source with the attributes "+sun-hours" (mean), "+sun-hours-min" and
/// "+sun-hours-max" of each of its objects. Throws InputError: the file isn't the one that was
/// planned.
std::string cityJsonWithHours(std::span<const ObjectHours> objects, const Plan& plan,
                              const PlannedSource& planned);

} // namespace edgeshade::city
