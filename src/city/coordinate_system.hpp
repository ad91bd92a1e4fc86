#pragma once

#include "src/sun/place.hpp"

#include <glm/glm.hpp>

namespace edgeshade::city {

/// A point of a frame on the globe.
struct FramePlace {
    sun::Place place;
    double north = 0.0; ///< degrees clockwise from the frame's +y to true north there
};

/// The place of a point in metres, by the EPSG code of its projected coordinates, with PROJ. Throws
/// InputError for a code that PROJ doesn't know, or whose coordinates aren't metres east and north;
/// Error(unavailable) if the program was built without PROJ.
FramePlace placeInSystem(int epsg, const glm::dvec3& point);

/// The code of a compound system's horizontal part, such as 28992 of 7415; of other systems, and if
/// the program was built without PROJ, the code itself.
int horizontalSystemOf(int epsg);

} // namespace edgeshade::city
