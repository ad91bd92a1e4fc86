#include "src/render/near_plane.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace edgeshade {
namespace {

constexpr double widening = 1.001; // of the pyramid, against rounding
constexpr double infinity = std::numeric_limits<double>::infinity();

/// A convex polygon: a triangle clipped by at most five planes.
struct Polygon {
    std::array<glm::dvec3, 8> corners;
    std::size_t count = 0;

    void add(const glm::dvec3& corner) { corners[count++] = corner; }
};

/// Keeps the part of the polygon where dot(normal, p) >= 0 (Sutherland-Hodgman).
Polygon clipped(const Polygon& polygon, const glm::dvec3& normal) {
    Polygon kept;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const glm::dvec3& here = polygon.corners[i];
        const glm::dvec3& next = polygon.corners[(i + 1) % polygon.count];
        const double a = glm::dot(normal, here);
        const double b = glm::dot(normal, next);
        if (a >= 0.0) kept.add(here);
        if ((a >= 0.0) != (b >= 0.0)) kept.add(here + (next - here) * (a / (a - b)));
    }
    return kept;
}

} // namespace

double nearestVisibleDepth(const Batch& batch, const Camera& camera, double aspect) {
    const double t = widening * std::tan(glm::radians(0.5 * camera.fovDegrees));
    // Planes through the eye in camera space, insides positive; the last keeps what is in front.
    const glm::dvec3 planes[] = {{1.0, 0.0, -t * aspect},
                                 {-1.0, 0.0, -t * aspect},
                                 {0.0, 1.0, -t},
                                 {0.0, -1.0, -t},
                                 {0.0, 0.0, -1.0}};
    const glm::dmat4 viewFromBatch = viewFromWorld(camera) * batch.worldFromBatch;
    std::vector<glm::dvec3> points;
    points.reserve(batch.positions.size());
    for (const glm::vec3& position : batch.positions)
        points.emplace_back(viewFromBatch * glm::dvec4(position, 1.0));

    double nearest = infinity;
    for (std::size_t i = 0; i + 2 < batch.indices.size(); i += 3) {
        Polygon polygon;
        for (std::size_t c = 0; c < 3; ++c)
            polygon.add(points[batch.indices[i + c]]);
        const double depth =
            -std::max({polygon.corners[0].z, polygon.corners[1].z, polygon.corners[2].z});
        if (depth >= nearest) continue;
        for (const glm::dvec3& plane : planes) {
            polygon = clipped(polygon, plane);
            if (polygon.count == 0) break;
        }
        for (std::size_t c = 0; c < polygon.count; ++c)
            nearest = std::min(nearest, std::max(0.0, -polygon.corners[c].z));
    }
    return nearest;
}

double fittedNear(const std::vector<double>& depths, double diagonal) {
    double nearest = infinity;
    for (const double depth : depths)
        nearest = std::min(nearest, depth);
    const double smallest = diagonal > 0.0 ? 1e-6 * diagonal : 1e-6;
    return std::isfinite(nearest) ? std::max(0.99 * nearest, smallest)
                                  : std::max(0.01 * diagonal, smallest);
}

} // namespace edgeshade
