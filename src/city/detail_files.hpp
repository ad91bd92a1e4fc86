#pragma once

#include "src/city/geo_tiff.hpp"
#include "src/city/map_sweep.hpp"

#include <fstream>
#include <optional>

namespace edgeshade::city {

/// Hours by month as a GeoTIFF of twelve bands, written row by row.
class MonthsFile {
  public:
    /// Throws as GeoTiffWriter does.
    MonthsFile(const std::filesystem::path& path, const Plan& plan);

    void add(const MapRow& row);
    void finish() { writer_.finish(); }

  private:
    double hoursOfPosition_;
    GeoTiffWriter writer_;
};

/// A map's bits as a NumPy array of bytes, written row by row: rows from the north, columns from
/// the west, packed positions. numpy.unpackbits(array, axis=2, count=positions) makes an array of 0
/// and 1.
class BitsFile {
  public:
    /// Throws Error(output) naming the path.
    BitsFile(const std::filesystem::path& path, const Plan& plan);

    void add(const MapRow& row);
    void finish();

  private:
    void require() const;

    std::filesystem::path path_;
    std::ofstream file_;
};

} // namespace edgeshade::city
