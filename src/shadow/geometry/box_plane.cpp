#include "src/shadow/geometry/box_plane.hpp"

#include <algorithm>

namespace edgeshade {

double largestOver(const Box& box, const glm::dvec4& plane, double w) {
    const glm::dvec3 normal(plane);
    const glm::dvec3 center = box.center();
    return glm::dot(normal, center) + glm::dot(glm::abs(normal), box.high - center) + plane.w * w;
}

glm::dvec4 planeAround(const Box& box, const glm::dvec3& normal) {
    return {normal, largestOver(box, glm::dvec4(-normal, 0.0))};
}

double roundingOf(const Box& box, const glm::dvec4& plane) {
    const glm::dvec3 farthest = glm::max(glm::abs(box.low), glm::abs(box.high));
    return placingError * (glm::dot(glm::abs(glm::dvec3(plane)), farthest) + std::abs(plane.w));
}

bool isOutside(const Box& box, const glm::dvec4& plane) {
    return largestOver(box, plane) < -roundingOf(box, plane);
}

bool areApart(const Box& inWorld, const Box& placed, const glm::dmat4& worldFromPlaced) {
    if (inWorld.empty()) return false;
    for (glm::length_t axis = 0; axis < 3; ++axis)
        for (const double sign : {-1.0, 1.0}) {
            glm::dvec3 normal(0.0);
            normal[axis] = sign;
            if (isOutside(placed, planeAround(inWorld, normal) * worldFromPlaced)) return true;
        }
    return false;
}

bool isOutsideOf(const Box& box, const glm::dvec4& point) {
    if (point.w == 0.0) return true;
    const glm::dvec3 at = glm::dvec3(point) / point.w;
    const double margin =
        placingError * std::max({glm::length(box.low), glm::length(box.high), glm::length(at)});
    return glm::any(glm::lessThan(box.high + margin, at)) ||
           glm::any(glm::lessThan(at + margin, box.low));
}

} // namespace edgeshade
