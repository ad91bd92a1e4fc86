#pragma once

#include "src/hours/surfaces/surface_run.hpp"

namespace edgeshade::hours {

/// Columns that a table has on request.
struct CsvColumns {
    bool when = false; ///< first and last: the clock's times between which the sun reaches the cell
};

/// A table of all cells as CSV (RFC 4180, lines end with LF): x, y, z of the sensor and nx, ny, nz
/// of its normal in the scene; area_m2, hours, node, material; node_index and material_index in the
/// file; left_out: "inside" a solid or "within" another cell's surface. After them come the columns
/// of CsvColumns, hours_01 to hours_12 by month, and direct_kwh_per_m2, where the run has them.
/// Numbers have as many digits as read back exactly; hours have what a step divides.
std::string csvOf(const SurfaceRun& run, const CsvColumns& columns);

} // namespace edgeshade::hours
