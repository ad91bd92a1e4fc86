#pragma once

#include "src/city/plan.hpp"

#include <memory>
#include <span>

namespace edgeshade::city {

/// Writes hours of sun as a GeoTIFF, row by row: bands of floats in tiles of 256 by 256, deflated,
/// north up, with the EPSG code of the plan's coordinates if there is one. Cells without a surface
/// are -1, which is declared as no data. The same map gives the same bytes. A map that might not
/// fit into TIFF's 4 GiB is a BigTIFF. Holds 256 rows.
class GeoTiffWriter {
  public:
    /// `bands`: their names; one may be empty. Throws Error(output) naming the path;
    /// Error(unavailable) if the program was built without libgeotiff.
    GeoTiffWriter(const std::filesystem::path& path, const Plan& plan,
                  std::span<const std::string> bands);
    ~GeoTiffWriter();

    /// Adds the next row from the north: hours of each cell of the plan's region, from the west,
    /// a cell's bands side by side.
    /// Throws Error(output): the disk is full.
    void add(std::span<const float> hours);
    /// Completes the file after the last row. Throws Error(output), too.
    void finish();

  private:
    class Writing;
    std::unique_ptr<Writing> writing_;
};

/// Whether a map with that many bands may exceed the 4 GiB of a TIFF, however badly it deflates.
bool takesBigTiff(const CellRange& region, std::size_t bands);

/// Hours of a cell that has no surface.
inline constexpr float noHours = -1.0f;

} // namespace edgeshade::city
