#include "src/render/visible_depth.hpp"

#include "src/render/polygon.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace edgeshade {
namespace {

constexpr double widening = 1.001; // of the pyramid, against rounding

} // namespace

VisiblePart visiblePart(const Batch& batch, const Camera& camera, double aspect) {
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

    const glm::dmat4 worldFromView = glm::inverse(viewFromWorld(camera));
    const auto inWorld = [&](const glm::dvec3& point) {
        return glm::dvec3(worldFromView * glm::dvec4(point, 1.0));
    };
    VisiblePart part;
    for (std::size_t i = 0; i + 2 < batch.indices.size(); i += 3) {
        Polygon polygon;
        DepthRange whole;
        for (std::size_t c = 0; c < 3; ++c) {
            polygon.add(points[batch.indices[i + c]]);
            whole.add(-polygon.corners[c].z);
        }
        const bool known =
            part.depth.contains(whole.nearest, whole.farthest) &&
            std::all_of(polygon.corners.begin(), polygon.corners.begin() + 3,
                        [&](const glm::dvec3& corner) { return part.box.holds(inWorld(corner)); });
        if (known) continue;
        for (const glm::dvec3& plane : planes) {
            polygon = clipped(polygon, plane);
            if (polygon.count == 0) break;
        }
        for (std::size_t c = 0; c < polygon.count; ++c)
            part.depth.add(std::max(0.0, -polygon.corners[c].z));
        for (std::size_t c = 0; c < polygon.count; ++c)
            part.box.add(inWorld(polygon.corners[c]));
    }
    return part;
}

} // namespace edgeshade
