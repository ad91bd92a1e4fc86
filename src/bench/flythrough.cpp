#include "src/bench/flythrough.hpp"

#include <cmath>
#include <numbers>

namespace edgeshade::bench {
namespace {

constexpr double pi = std::numbers::pi;

} // namespace

Flythrough::Flythrough(const Box& bounds, double fovDegrees, double aspect)
    : center_(bounds.center()),
      framing_(glm::distance(framingCamera(bounds, fovDegrees, aspect).from, center_)),
      fovDegrees_(fovDegrees) {}

Camera Flythrough::cameraAt(double share) const {
    const double angle = 2.0 * pi * (share - std::floor(share));
    const double outside = 0.5 + 0.5 * std::cos(angle); // 1 at the start, 0 half way
    const double distance = framing_ * (0.25 + 0.8 * outside);
    const double height = glm::radians(6.0 + 22.0 * outside);
    const double around = angle + 0.5; // never looks along an axis of the scene
    const glm::dvec3 direction(std::sin(around) * std::cos(height), std::sin(height),
                               std::cos(around) * std::cos(height));
    return {center_ + distance * direction, center_, fovDegrees_};
}

std::vector<Light> movedLights(const std::vector<Light>& lights, const Box& bounds, double size,
                               double share) {
    const double angle = 2.0 * pi * share;
    const glm::dvec2 circle(std::sin(angle), 1.0 - std::cos(angle));
    std::vector<Light> moved = lights;
    for (Light& light : moved) {
        glm::dvec4& position = light.position;
        if (position.w == 1.0) {
            position += size / 150.0 * bounds.diagonal() * glm::dvec4(circle.x, 0.0, circle.y, 0.0);
            continue;
        }
        const glm::dvec3 towards = glm::normalize(glm::dvec3(position));
        const glm::dvec3 axis =
            std::abs(towards.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
        const glm::dvec3 right = glm::normalize(glm::cross(axis, towards));
        const glm::dvec3 up = glm::cross(towards, right);
        const double radius = std::tan(glm::radians(size));
        position = glm::dvec4(towards + radius * (circle.x * right + circle.y * up), 0.0);
    }
    return moved;
}

} // namespace edgeshade::bench
