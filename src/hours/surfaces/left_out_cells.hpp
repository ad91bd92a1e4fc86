#pragma once

#include "src/hours/surfaces/cells.hpp"

namespace edgeshade::hours {

/// The triangles of all closed components of opaque casters, chosen or not, in the world.
/// `castMasked` as in CasterSettings.
std::vector<WorldTriangle> solidSurfaces(const Scene& scene, bool castMasked);

/// Marks the cells that are left out of shares.
///
/// CellState::inside: just off its surface, the sensor has a winding number other than 0 with
/// respect to `solids`. So a floor beneath a house is inside, and a room's wall isn't, if the room
/// is hollow. Surfaces of solids that are wound inwards are inside too.
///
/// CellState::within: an earlier chosen triangle of another patch lies in the sensor's plane, faces
/// the same way and holds the sensor.
///
/// A point on a plane, here, is nearer to it than a file's floats can tell.
void markLeftOut(SurfaceCells& cells, std::span<const WorldTriangle> solids);

} // namespace edgeshade::hours
