#include "src/plot/shape.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace edgeshade::plot {
namespace {

/// Corners at even angles, the first at `turn` of a full turn from straight up, with alternating
/// radii.
template <std::size_t count>
std::vector<Point> around(Point center, int corners, double turn,
                          const std::array<double, count>& radii) {
    std::vector<Point> points;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * std::numbers::pi * (turn + static_cast<double>(i) / corners);
        const double radius = radii[static_cast<std::size_t>(i) % count];
        points.push_back(
            {center.x + radius * std::sin(angle), center.y - radius * std::cos(angle)});
    }
    return points;
}

/// A cross, turned by an eighth.
std::vector<Point> crossAround(Point center, double reach, double half) {
    const double c = std::numbers::sqrt2 / 2.0;
    std::array<Point, 3> arm = {{{-half, -reach}, {half, -reach}, {half, -half}}};
    std::vector<Point> points;
    for (int quarter = 0; quarter < 4; ++quarter)
        for (Point& corner : arm) {
            const auto [x, y] = corner;
            points.push_back({center.x + c * (x - y), center.y + c * (x + y)});
            corner = {-y, x};
        }
    return points;
}

} // namespace

std::vector<Point> outlineOf(Shape shape, Point center, double radius) {
    const std::array<double, 1> wide = {1.3 * radius}, plain = {1.1 * radius};
    switch (shape) {
    case Shape::disc:
        break;
    case Shape::square:
        return around(center, 4, 0.125, wide);
    case Shape::diamond:
        return around(center, 4, 0.0, wide);
    case Shape::triangle:
        return around(center, 3, 0.0, wide);
    case Shape::wedge:
        return around(center, 3, 0.5, wide);
    case Shape::star:
        return around(center, 10, 0.0, std::array{1.5 * radius, 0.65 * radius});
    case Shape::cross:
        return crossAround(center, 1.35 * radius, 0.45 * radius);
    case Shape::hexagon:
        return around(center, 6, 0.0, plain);
    }
    return {};
}

} // namespace edgeshade::plot
