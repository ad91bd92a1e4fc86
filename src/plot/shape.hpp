#pragma once

#include <vector>

namespace edgeshade::plot {

struct Point {
    double x = 0.0; ///< pixels, from the left
    double y = 0.0; ///< from the top
};

/// The mark of a point in a plot.
enum class Shape { disc, square, diamond, triangle, wedge, star, cross, hexagon };
inline constexpr int shapeCount = 8;

/// The corners of a shape around a centre, that looks as large as a disc of that radius; empty for
/// a disc. A wedge is a triangle that points down.
std::vector<Point> outlineOf(Shape shape, Point center, double radius);

} // namespace edgeshade::plot
