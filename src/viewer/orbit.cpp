#include "src/viewer/orbit.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade::viewer {
namespace {

constexpr double steepest = glm::radians(89.9); // largest pitch; beyond it `up` loses its meaning

double tangentOfHalfFov(const Camera& camera) {
    return std::tan(glm::radians(0.5 * camera.fovDegrees));
}

/// The picture's right and up axes in the world.
std::pair<glm::dvec3, glm::dvec3> pictureAxes(const Camera& camera) {
    const glm::dmat3 worldFromView = glm::transpose(glm::dmat3(viewFromWorld(camera)));
    return {worldFromView[0], worldFromView[1]};
}

/// Angle around +Y from +Z to +X; also right where the camera looks straight up or down.
double yawOf(const Camera& camera) {
    const auto [right, up] = pictureAxes(camera);
    return std::atan2(-right.z, right.x);
}

} // namespace

double PictureView::pixelAt(double depth) const {
    return 2.0 * depth * tangentOfHalfFov(camera) / height;
}

glm::dvec3 PictureView::forward() const {
    return glm::normalize(camera.to - camera.from);
}

double PictureView::depthOf(const glm::dvec3& point) const {
    return glm::dot(point - camera.from, forward());
}

glm::dvec3 PictureView::pointAt(const glm::dvec2& pixel, double depth) const {
    const auto [right, up] = pictureAxes(camera);
    const glm::dvec2 fromMiddle = (pixel - 0.5 * glm::dvec2(width, height)) * pixelAt(depth);
    return camera.from + forward() * depth + right * fromMiddle.x - up * fromMiddle.y;
}

Ray PictureView::rayThrough(const glm::dvec2& pixel) const {
    return {camera.from, glm::normalize(pointAt(pixel, 1.0) - camera.from)};
}

glm::dvec2 PictureView::pixelOf(const glm::dvec3& point) const {
    const auto [right, up] = pictureAxes(camera);
    const glm::dvec3 offset = point - camera.from;
    const double pixel = pixelAt(depthOf(point));
    return 0.5 * glm::dvec2(width, height) +
           glm::dvec2(glm::dot(offset, right), -glm::dot(offset, up)) / pixel;
}

Camera orbited(const Camera& camera, double yaw, double pitch) {
    const glm::dvec3 arm = camera.from - camera.to;
    const double distance = glm::length(arm);
    const double newYaw = yawOf(camera) + yaw;
    const double newPitch =
        std::clamp(std::asin(std::clamp(arm.y / distance, -1.0, 1.0)) + pitch, -steepest, steepest);
    Camera result = camera;
    result.from =
        camera.to + distance * glm::dvec3(std::cos(newPitch) * std::sin(newYaw), std::sin(newPitch),
                                          std::cos(newPitch) * std::cos(newYaw));
    return result;
}

Camera panned(const PictureView& view, const glm::dvec2& pixels, double depth) {
    const auto [right, up] = pictureAxes(view.camera);
    const glm::dvec3 move = (up * pixels.y - right * pixels.x) * view.pixelAt(depth);
    Camera result = view.camera;
    result.from += move;
    result.to += move;
    return result;
}

Camera zoomed(const Camera& camera, const glm::dvec3& target, double factor, double nearest,
              double farthest) {
    const double distance = glm::distance(camera.from, camera.to) * factor;
    if (distance < nearest || distance > farthest) return camera;
    Camera result = camera;
    result.from = target + (camera.from - target) * factor;
    result.to = target + (camera.to - target) * factor;
    return result;
}

} // namespace edgeshade::viewer
