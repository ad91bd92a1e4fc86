#include "src/shadow/lights/light_shape.hpp"

#include <cmath>

namespace edgeshade {

double LightShape::support(const glm::dvec3& normal) const {
    const glm::dvec3 along = normal * arms;
    return round ? glm::length(along) : std::abs(along.x) + std::abs(along.y) + std::abs(along.z);
}

LightShape LightShape::in(const glm::dmat4& space) const {
    return {space * center, glm::dmat3(space) * arms, round};
}

bool castAlike(const Light& a, const Light& b) {
    return a.position == b.position && a.range == b.range && a.extent == b.extent;
}

int sideOfAll(const std::array<glm::dvec3, 3>& corners, const LightShape& light) {
    constexpr double rounding = 1e-9;
    const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const glm::dvec3 center(light.center);
    const double side = glm::dot(normal, center - light.center.w * corners[0]);
    const double size = glm::length(center) + std::abs(light.center.w) * glm::length(corners[0]);
    const double doubt = light.support(normal) + rounding * glm::length(normal) * size;
    return side > doubt ? 1 : side < -doubt ? -1 : 0;
}

} // namespace edgeshade
