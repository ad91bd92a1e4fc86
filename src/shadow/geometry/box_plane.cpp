#include "src/shadow/geometry/box_plane.hpp"

namespace edgeshade {

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
