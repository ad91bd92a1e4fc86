#include "src/render/visible_depth.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace edgeshade {
namespace {

constexpr double widening = 1.001; // of the pyramid, against rounding

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

DepthRange visibleDepth(const Batch& batch, const Camera& camera, double aspect) {
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

    DepthRange range;
    for (std::size_t i = 0; i + 2 < batch.indices.size(); i += 3) {
        Polygon polygon;
        DepthRange whole;
        for (std::size_t c = 0; c < 3; ++c) {
            polygon.add(points[batch.indices[i + c]]);
            whole.add(-polygon.corners[c].z);
        }
        if (range.contains(whole.nearest, whole.farthest)) continue;
        for (const glm::dvec3& plane : planes) {
            polygon = clipped(polygon, plane);
            if (polygon.count == 0) break;
        }
        for (std::size_t c = 0; c < polygon.count; ++c)
            range.add(std::max(0.0, -polygon.corners[c].z));
    }
    return range;
}

} // namespace edgeshade
