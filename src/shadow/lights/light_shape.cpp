#include "src/shadow/lights/light_shape.hpp"

#include "src/shadow/geometry/vectors.hpp"
#include "src/shadow/lights/light_extent.hpp"

#include <cmath>

namespace edgeshade {

double LightShape::support(const glm::dvec3& normal) const {
    const glm::dvec3 along = normal * arms;
    return round ? glm::length(along) : std::abs(along.x) + std::abs(along.y) + std::abs(along.z);
}

LightShape LightShape::in(const glm::dmat4& space) const {
    return {space * center, glm::dmat3(space) * arms, round};
}

LightShape shapeOf(const Light& light) {
    LightShape shape;
    shape.center = light.position;
    if (!light.extent) return shape;
    const LightExtent& extent = *light.extent;
    if (extent.shape == LightExtent::Shape::disc) {
        const glm::dvec3 towards = unitOf(glm::dvec3(light.position));
        const auto [right, up, forward] = axesAlong(towards);
        shape.center = glm::dvec4(towards, 0.0);
        shape.arms = glm::dmat3(std::tan(extent.radius) * right, std::tan(extent.radius) * up,
                                glm::dvec3(0.0));
        return shape;
    }
    shape.center = light.position / light.position.w;
    if (extent.shape == LightExtent::Shape::sphere) {
        shape.arms = glm::dmat3(extent.radius);
        return shape;
    }
    const auto [across, up] = rectangleAxes(extent.direction);
    shape.arms =
        glm::dmat3(0.5 * extent.size.x * across, 0.5 * extent.size.y * up, glm::dvec3(0.0));
    shape.round = false;
    return shape;
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
