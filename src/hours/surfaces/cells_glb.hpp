#pragma once

#include "preprocess/base/file_io.hpp"
#include "src/hours/surfaces/surface_run.hpp"

namespace edgeshade::hours {

/// The linear colour of a share from 0 to 1 of the largest value.
using CellColor = std::function<glm::dvec3(double share)>;

/// All cells as a mesh (glTF 2.0, GLB) where the scene's surfaces are, with a node and a mesh for
/// each of its nodes that have cells; cells that are left out are grey. Each cell has corners of
/// its own: POSITION, NORMAL, COLOR_0 and the scalar _HOURS, or _DIRECT_KWH too where the run has
/// energies, which then are the colours. Materials are unlit. `most`: the value at a share of 1,
/// above 0.
///
/// The asset's extras say the scale. Throws Error(output) beyond the 4 GiB of a GLB.
Bytes glbOf(const SurfaceRun& run, const CellColor& color, double most);

} // namespace edgeshade::hours
