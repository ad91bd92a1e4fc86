#pragma once

#include "src/hours/surfaces/cells.hpp"

namespace edgeshade::hours {

/// Divides each patch's rectangle along its axes into equal cells, and cuts the patch by them.
/// Areas are those of the triangles, so they sum up to the mesh's own. A sensor is in the middle of
/// its cell, a hair beside the edges of triangles. If the middle is off the patch, the sensor is in
/// the middle of the cell's part, or else in that of the part's largest face.
///
/// Throws Error(usage) naming --grid: more than mostCells, or cells too small for the scene.
SurfaceCells cellsOf(const Scene& scene, const SurfaceChoice& choice, const GridSettings& grid);

} // namespace edgeshade::hours
