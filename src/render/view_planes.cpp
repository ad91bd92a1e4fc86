#include "src/render/view_planes.hpp"

#include <algorithm>

namespace edgeshade {

ViewPlanes viewPlanes(const FrameView& view, const DepthSlice& slice,
                      const glm::dmat4& worldFromBatch) {
    const double aspect = static_cast<double>(view.width) / view.height;
    const glm::dmat4 rows = glm::transpose(clipFromView(view.camera, aspect, slice.near) *
                                           viewFromWorld(view.camera) * worldFromBatch);
    glm::dvec4 farthest = -rows[3]; // depth is w
    farthest.w += std::min(slice.far, view.farthestDepth) * (1.0 + 1e-3);
    return {rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1],
            rows[3] - rows[1], rows[3] + rows[2], farthest};
}

double largestOver(const Box& box, const glm::dvec4& plane, double w) {
    const glm::dvec3 normal(plane);
    const glm::dvec3 center = box.center();
    return glm::dot(normal, center) + glm::dot(glm::abs(normal), box.high - center) + plane.w * w;
}

double roundingOf(const Box& box, const glm::dvec4& plane) {
    const glm::dvec3 farthest = glm::max(glm::abs(box.low), glm::abs(box.high));
    return placingError * (glm::dot(glm::abs(glm::dvec3(plane)), farthest) + std::abs(plane.w));
}

bool isOutside(const Box& box, const glm::dvec4& plane) {
    return largestOver(box, plane) < -roundingOf(box, plane);
}

} // namespace edgeshade
