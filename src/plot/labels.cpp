#include "src/plot/labels.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace edgeshade::plot {
namespace {

double overlap(const Rectangle& a, const Rectangle& b) {
    const double width = std::min(a.right, b.right) - std::max(a.left, b.left);
    const double height = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
    return width > 0.0 && height > 0.0 ? width * height : 0.0;
}

double areaOf(const Rectangle& r) {
    return (r.right - r.left) * (r.bottom - r.top);
}

} // namespace

LabelPlaces::LabelPlaces(const Rectangle& inside, std::vector<Point> points, double radius)
    : inside_(inside) {
    for (const Point& p : points)
        taken_.push_back({p.x - radius, p.y - radius, p.x + radius, p.y + radius});
}

void LabelPlaces::keepOff(std::span<const Point> line) {
    constexpr double step = 8.0, half = 3.0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Point from = line[i - 1], to = line[i];
        const int steps = 1 + static_cast<int>(std::hypot(to.x - from.x, to.y - from.y) / step);
        for (int k = 0; k <= steps; ++k) {
            const double share = static_cast<double>(k) / steps;
            const double x = from.x + share * (to.x - from.x);
            const double y = from.y + share * (to.y - from.y);
            taken_.push_back({x - half, y - half, x + half, y + half});
        }
    }
}

double LabelPlaces::covered(const Rectangle& candidate) const {
    constexpr double unreadable = 20.0; // weight of overlapping names or leaving the area;
                                        // overlapping marks weighs 1
    double area = unreadable * (areaOf(candidate) - overlap(candidate, inside_));
    for (const Rectangle& other : taken_)
        area += overlap(candidate, other);
    for (const Rectangle& other : names_)
        area += unreadable * overlap(candidate, other);
    return area;
}

Rectangle LabelPlaces::place(const Point& point, double width, double height) {
    constexpr int directions = 16;
    Rectangle best;
    double least = std::numeric_limits<double>::infinity();
    for (double distance = 9.0; distance < 150.0; distance += 7.0)
        for (int i = 0; i < directions; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / directions;
            const double x = point.x + distance * std::cos(angle);
            const double y = point.y - distance * std::sin(angle);
            // The name's nearest edge is at this distance.
            const double left = x - width * 0.5 * (1.0 - std::cos(angle));
            const double top = y - height * 0.5 * (1.0 + std::sin(angle));
            const Rectangle candidate{left, top, left + width, top + height};
            const double cost = covered(candidate) + 0.6 * distance;
            if (cost < least) {
                least = cost;
                best = candidate;
            }
        }
    names_.push_back(best);
    return best;
}

} // namespace edgeshade::plot
