#include "src/shadow/view/camera.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade {

double tangentOfHalfFov(double fovDegrees) {
    return std::tan(glm::radians(0.5 * fovDegrees));
}

glm::dmat4 viewFromWorld(const Camera& camera) {
    const glm::dvec3 forward = glm::normalize(camera.to - camera.from);
    const bool vertical = std::hypot(forward.x, forward.z) < 1e-9;
    const glm::dvec3 up = vertical ? glm::dvec3(0.0, 0.0, -1.0) : glm::dvec3(0.0, 1.0, 0.0);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, up));
    const glm::dvec3 upward = glm::cross(right, forward);
    glm::dmat4 view(1.0);
    for (glm::length_t c = 0; c < 3; ++c)
        view[c] = {right[c], upward[c], -forward[c], 0.0};
    view[3] = {-glm::dot(right, camera.from), -glm::dot(upward, camera.from),
               glm::dot(forward, camera.from), 1.0};
    return view;
}

glm::dvec3 framingDirection() {
    return glm::normalize(glm::dvec3(0.55, 0.45, 1.0));
}

Camera framingCamera(const Box& box, double fovDegrees, double aspect) {
    return framingCamera(box, fovDegrees, aspect, framingDirection());
}

Camera framingCamera(const Box& box, double fovDegrees, double aspect,
                     const glm::dvec3& direction) {
    constexpr double margin = 1.06;
    const double tangentY = tangentOfHalfFov(fovDegrees) / margin;
    const double tangentX = tangentY * aspect;
    Camera camera{box.center() + direction, box.center(), fovDegrees};
    const glm::dmat4 view = viewFromWorld(camera);

    // The shortest distance that shows every corner of the box.
    double distance = std::max(1e-6 * box.diagonal(), 1e-9);
    for (int corner = 0; corner < 8 && !box.empty(); ++corner) {
        const glm::dvec3 offset = glm::dmat3(view) * (box.corner(corner) - box.center());
        distance = std::max({distance, offset.z + std::abs(offset.x) / tangentX,
                             offset.z + std::abs(offset.y) / tangentY});
    }
    camera.from = box.center() + distance * glm::normalize(direction);
    return camera;
}

} // namespace edgeshade
