#pragma once

#include "src/plot/canvas.hpp"

#include <vector>

namespace edgeshade::plot {

/// Finds places for names beside points, where they cover as little as they can of each other, of
/// the points and of what is outside.
class LabelPlaces {
  public:
    /// `points`: all of them, each `radius` large.
    LabelPlaces(const Rectangle& inside, std::vector<Point> points, double radius);

    /// Keeps names off a line through these points.
    void keepOff(std::span<const Point> line);

    /// The rectangle for a name of that size at the point; later names keep away from it.
    Rectangle place(const Point& point, double width, double height);

  private:
    double covered(const Rectangle& candidate) const;

    Rectangle inside_;
    std::vector<Rectangle> taken_; ///< by marks and lines
    std::vector<Rectangle> names_;
};

} // namespace edgeshade::plot
