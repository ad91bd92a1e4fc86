#include "src/shadow/view/plan_view.hpp"

#include <algorithm>

namespace edgeshade {

Frustum planView(const Scene& scene, double aspect, double north) {
    constexpr double margin = 1.04;
    const double turn = glm::radians(north);
    const glm::dvec3 right(std::cos(turn), 0.0, std::sin(turn));
    const glm::dvec3 up(std::sin(turn), 0.0, -std::cos(turn)), back(0.0, 1.0, 0.0);
    const glm::dmat3 worldFromView(right, up, back);

    Box seen;
    for (const Batch& batch : scene.batches) {
        if (batch.ground) continue;
        for (const glm::vec3& position : batch.geometry->positions)
            seen.add(glm::transpose(worldFromView) *
                     glm::dvec3(batch.worldFromBatch * glm::dvec4(position, 1.0)));
    }
    if (seen.empty()) seen.add(glm::dvec3(0.0));
    const glm::dvec3 size = seen.high - seen.low;
    const double least = std::max(1e-6 * seen.diagonal(), 1e-9);
    const double height = margin * std::max({size.y, size.x / aspect, least});

    const glm::dvec3 eye = worldFromView * glm::dvec3(glm::dvec2(seen.center()), seen.high.z);
    Frustum frustum;
    frustum.orthographic = true;
    frustum.high = 0.5 * glm::dvec2(height * aspect, height);
    frustum.low = -frustum.high;
    frustum.viewFromWorld = glm::dmat4(glm::transpose(worldFromView));
    frustum.viewFromWorld[3] = glm::dvec4(-(glm::transpose(worldFromView) * eye), 1.0);
    return frustum;
}

} // namespace edgeshade
