#pragma once

#include "src/hours/surfaces/cells.hpp"

namespace edgeshade::hours {

/// Adds the cells of one patch of `cells.triangles`. Throws as cellsOf() does.
void addPatchCells(const Patch& patch, const GridSettings& grid, SurfaceCells& cells);

} // namespace edgeshade::hours
