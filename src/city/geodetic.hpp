#pragma once

#include "src/sun/place.hpp"

#include <glm/glm.hpp>

namespace edgeshade::city {

/// The place of an earth-centred, earth-fixed point on WGS 84 (EPSG 4978), by Bowring 1985: within
/// a nanometre near the ground. `point`: metres, outside of the earth's core.
sun::Place placeOfEcef(const glm::dvec3& point);

/// The inverse: the point at a height above the ellipsoid, in metres.
glm::dvec3 ecefOf(const sun::Place& place, double height);

/// Earth-centred, earth-fixed coordinates from metres east, north and up at a point.
glm::dmat4 ecefFromEastNorthUp(const glm::dvec3& origin);

/// The inverse of a rigid transform.
glm::dmat4 rigidInverse(const glm::dmat4& transform);

} // namespace edgeshade::city
