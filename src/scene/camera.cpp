#include "src/scene/camera.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade {
namespace {

double tangentOfHalfFov(double fovDegrees) { return std::tan(glm::radians(0.5 * fovDegrees)); }

} // namespace

glm::dmat4 viewFromWorld(const Camera& camera) {
    const glm::dvec3 forward = glm::normalize(camera.to - camera.from);
    const bool vertical = std::hypot(forward.x, forward.z) < 1e-9;
    const glm::dvec3 up = vertical ? glm::dvec3(0.0, 0.0, -1.0) : glm::dvec3(0.0, 1.0, 0.0);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, up));
    const glm::dvec3 upward = glm::cross(right, forward);
    glm::dmat4 view(1.0);
    for (glm::length_t c = 0; c < 3; ++c) view[c] = {right[c], upward[c], -forward[c], 0.0};
    view[3] = {-glm::dot(right, camera.from), -glm::dot(upward, camera.from),
               glm::dot(forward, camera.from), 1.0};
    return view;
}

glm::dmat4 clipFromView(const Camera& camera, double aspect, double near) {
    const double t = tangentOfHalfFov(camera.fovDegrees);
    glm::dmat4 clip(0.0);
    clip[0][0] = 1.0 / (t * aspect);
    clip[1][1] = 1.0 / t;
    clip[2][2] = -1.0;
    clip[2][3] = -1.0;
    clip[3][2] = -2.0 * near;
    return clip;
}

Camera framingCamera(const Box& box, double fovDegrees, double aspect) {
    const double t = tangentOfHalfFov(fovDegrees) * std::min(1.0, aspect);
    const double radius = std::max(0.5 * box.diagonal(), 1e-9);
    const double distance = 0.95 * radius / std::sin(std::atan(t));
    const glm::dvec3 direction = glm::normalize(glm::dvec3(0.55, 0.45, 1.0));
    return {box.center() + distance * direction, box.center(), fovDegrees};
}

} // namespace edgeshade
