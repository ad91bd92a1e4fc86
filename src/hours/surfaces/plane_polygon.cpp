#include "src/hours/surfaces/plane_polygon.hpp"

#include <algorithm>
#include <limits>

namespace edgeshade::hours {
namespace {

double crossOf(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

/// Keeps what is at `line` or beyond it; `sign`: 1 for greater coordinates, -1 for less.
PlanePolygon halfOf(const PlanePolygon& polygon, glm::length_t axis, double line, double sign) {
    PlanePolygon kept;
    kept.reserve(polygon.size() + 1);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const double before = sign * (p[axis] - line), after = sign * (q[axis] - line);
        if (before >= 0.0) kept.push_back(p);
        if ((before > 0.0 && after < 0.0) || (before < 0.0 && after > 0.0)) {
            glm::dvec2 cut = p + (before / (before - after)) * (q - p);
            cut[axis] = line;
            kept.push_back(cut);
        }
    }
    return kept;
}

} // namespace

PlanePolygon slabOf(const PlanePolygon& polygon, glm::length_t axis, double low, double high) {
    PlanePolygon part = halfOf(halfOf(polygon, axis, low, 1.0), axis, high, -1.0);
    if (part.size() < 3) part.clear();
    return part;
}

double areaOf(const PlanePolygon& polygon) {
    double twice = 0.0;
    for (std::size_t i = 2; i < polygon.size(); ++i)
        twice += crossOf(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
    return 0.5 * twice;
}

glm::dvec2 centerOf(const PlanePolygon& polygon) {
    glm::dvec2 weighted(0.0), sum(0.0);
    double twice = 0.0;
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        const glm::dvec2 p = polygon[i - 1] - polygon[0], q = polygon[i] - polygon[0];
        twice += crossOf(p, q);
        weighted += crossOf(p, q) * (p + q) / 3.0;
    }
    if (twice > 0.0) return polygon[0] + weighted / twice;
    for (const glm::dvec2& corner : polygon)
        sum += corner;
    return sum / static_cast<double>(polygon.size());
}

double depthIn(const PlanePolygon& polygon, const glm::dvec2& point) {
    double depth = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 side = polygon[(i + 1) % polygon.size()] - polygon[i];
        const double length = glm::length(side);
        if (length > 0.0) depth = std::min(depth, crossOf(side, point - polygon[i]) / length);
    }
    return depth;
}

} // namespace edgeshade::hours
