#pragma once

#include <vector>

namespace edgeshade::plot {

struct Point {
    double x = 0.0; ///< pixels, from the left
    double y = 0.0; ///< from the top
};

/// What marks a point of a plot.
enum class Shape { disc, square, diamond, triangle, wedge, star, cross, hexagon };
inline constexpr int shapeCount = 8;

/// The corners of a shape around a place, as large to the eye as a disc of that radius; none of a
/// disc. A wedge is a triangle that points down.
std::vector<Point> outlineOf(Shape shape, Point center, double radius);

} // namespace edgeshade::plot
