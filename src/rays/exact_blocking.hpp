#pragma once

#include "src/rays/surface_point.hpp"

namespace edgeshade::rays {

/// Whether light reaches or leaves something, in integers without rounding: all inputs are taken as
/// the doubles that they are, which must be finite (docs/method.md, C30 and C56). Takes some
/// microseconds, and allocates.

enum class Blocking {
    blocks,
    misses,
    inPlane, ///< the point is in the triangle's plane, so that it misses light from anywhere
};

/// Whether a triangle blocks the light of a point: they meet between the two. Triangles in the
/// plane of the point's own don't, as they meet the light at the point itself. `own`: null: the
/// point is on no triangle. `light`: homogeneous, w = 0 or 1.
Blocking blockingExactly(const SurfacePoint& point, const Corners* own, const Corners& other,
                         const glm::dvec4& light);
bool blocksExactly(const SurfacePoint& point, const Corners* own, const Corners& other,
                   const glm::dvec4& light);

/// The sign of dot(normal, direction), where the triangle's corners run counter-clockwise about its
/// normal.
int sideExactly(const Corners& triangle, const glm::dvec3& direction);

/// The sign of dot(a, b).
int dotSignExactly(const glm::dvec3& a, const glm::dvec3& b);

/// The point, rounded once; see SurfacePoint.
glm::dvec3 placeExactly(const SurfacePoint& point, const Corners& own);

} // namespace edgeshade::rays
