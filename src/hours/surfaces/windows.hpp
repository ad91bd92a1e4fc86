#pragma once

#include "src/hours/surfaces/cells.hpp"
#include "src/hours/surfaces/sensor_light.hpp"

namespace edgeshade::hours {

/// Distances in windows, in scene units.
struct WindowSettings {
    double flatness = 0.01;          ///< by which a pane may leave its plane, above 0
    double offset = 0.0;             ///< of sensors from their panes, along the normal; 0 or more
    std::optional<double> rise = {}; ///< see GridSettings
};

/// The windows among the chosen surfaces, a cell each. A window is a group of triangles of one node
/// and one material that edges connect; its cell is its largest patch. Of several that are about as
/// large, as the two sides of a pane are, it is the one that sees most of the sky. The sensor is in
/// the middle of that patch's rectangle, or as high in it as `rise` says, or as for cellsOf() if
/// that is off the patch.
SurfaceCells windowsOf(const Scene& scene, const SurfaceChoice& choice,
                       const WindowSettings& settings, const SensorLight& light);

} // namespace edgeshade::hours
