#pragma once

#include "src/hours/surfaces/surface_run.hpp"

namespace edgeshade::hours {

/// Light at all cells of a run from some of its sun positions; a whole run is part 1 of 1.
struct SurfacePart : PartNumber {
    /// Positions and light are the part's: every of-th position of the run; see countOfPart(). A
    /// part has bits of light alone.
    SurfaceRun run;
    std::vector<double> beam; ///< W/m² by position of the whole run; empty: no energy
    /// All triangles of the scene; the cells' are some of them, in that order.
    std::vector<WorldTriangle> scene;
};

} // namespace edgeshade::hours
