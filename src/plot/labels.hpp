#pragma once

#include "src/plot/canvas.hpp"

#include <vector>

namespace edgeshade::plot {

/// Places names beside points so that they cover as little as possible of each other, the points
/// and the area outside.
class LabelPlaces {
  public:
    /// `points`: all points; `radius`: their size.
    LabelPlaces(const Rectangle& inside, std::vector<Point> points, double radius);

    /// Keeps names off a line through these points.
    void keepOff(std::span<const Point> line);

    /// The rectangle of a name of that size at the point; later names avoid it.
    Rectangle place(const Point& point, double width, double height);

  private:
    double covered(const Rectangle& candidate) const;

    Rectangle inside_;
    std::vector<Rectangle> taken_; ///< rectangles of marks and lines
    std::vector<Rectangle> names_;
};

} // namespace edgeshade::plot
