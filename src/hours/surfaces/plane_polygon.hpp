#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace edgeshade::hours {

/// A convex polygon on a plane, counter-clockwise.
using PlanePolygon = std::vector<glm::dvec2>;

/// The part of a convex polygon with low <= coordinate <= high along an axis (0: x, 1: y). Corners
/// on the same line get the same coordinate, bit by bit. Fewer than three corners: nothing is left.
PlanePolygon slabOf(const PlanePolygon& polygon, glm::length_t axis, double low, double high);

/// 0 for less than three corners.
double areaOf(const PlanePolygon& polygon);

/// The centre of gravity; the mean of the corners if the area is 0. At least one corner.
glm::dvec2 centerOf(const PlanePolygon& polygon);

/// Distance of a point from the nearest side, along the side's normal; negative outside.
double depthIn(const PlanePolygon& polygon, const glm::dvec2& point);

} // namespace edgeshade::hours
