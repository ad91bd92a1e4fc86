#include "src/shadow/lights/light_extent.hpp"

#include "src/shadow/geometry/quasirandom.hpp"
#include "src/shadow/geometry/vectors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace edgeshade {
namespace {

/// Maps a square's points evenly to a disc of radius 1, middle to middle (Shirley and Chiu 1997).
glm::dvec2 onDisc(const std::array<double, 2>& square) {
    constexpr double quarter = std::numbers::pi / 4.0;
    const double a = 2.0 * square[0] - 1.0, b = 2.0 * square[1] - 1.0;
    if (a == 0.0 && b == 0.0) return {0.0, 0.0};
    const bool wide = std::abs(a) > std::abs(b);
    const double r = wide ? a : b;
    const double angle = wide ? quarter * (b / a) : 2.0 * quarter - quarter * (a / b);
    return r * glm::dvec2(std::cos(angle), std::sin(angle));
}

/// The radius within a unit ball that contains that share of points, if every projection of them
/// fills a disc evenly. Their density is then 1 / sqrt(1 - r^2), Abel's inverse of a constant. With
/// r = sin(t) the share is (t - sin(t) cos(t)) / (pi / 2).
double distanceInBall(double share) {
    double low = 0.0, high = std::numbers::pi / 2.0;
    for (int halving = 0; halving < 60; ++halving) {
        const double t = 0.5 * (low + high);
        const bool isBelow = t - std::sin(t) * std::cos(t) < share * std::numbers::pi / 2.0;
        (isBelow ? low : high) = t;
    }
    return std::sin(0.5 * (low + high));
}

glm::dvec3 inBall(std::uint64_t n) {
    const std::array<double, 3> place = evenly<3>(n);
    const double z = 1.0 - 2.0 * place[0];
    const double across = std::sqrt(std::max(0.0, 1.0 - z * z));
    const double angle = 2.0 * std::numbers::pi * place[1];
    return distanceInBall(place[2]) *
           glm::dvec3(across * std::cos(angle), across * std::sin(angle), z);
}

/// The n-th point.
glm::dvec4 pointOf(const Light& light, std::uint64_t n) {
    const LightExtent& extent = *light.extent;
    if (extent.shape == LightExtent::Shape::disc) {
        const auto [right, up, forward] = axesAlong(unitOf(glm::dvec3(light.position)));
        const glm::dvec2 on = onDisc(evenly<2>(n));
        // Equal shares of the disc get equal shares of the solid angle.
        const double radius = glm::length(on) * std::sin(0.5 * extent.radius);
        const double sine = 2.0 * radius * std::sqrt(1.0 - radius * radius);
        const glm::dvec2 away = radius > 0.0 ? on * (sine / glm::length(on)) : glm::dvec2(0.0);
        return glm::dvec4(away.x * right + away.y * up + (1.0 - 2.0 * radius * radius) * forward,
                          0.0);
    }
    glm::dvec3 offset;
    if (extent.shape == LightExtent::Shape::sphere) {
        offset = extent.radius * inBall(n);
    } else {
        const auto [across, up] = rectangleAxes(extent.direction);
        const std::array<double, 2> place = evenly<2>(n);
        offset = (place[0] - 0.5) * extent.size.x * across + (place[1] - 0.5) * extent.size.y * up;
    }
    return glm::dvec4(glm::dvec3(light.position) / light.position.w + offset, 1.0);
}

} // namespace

std::array<glm::dvec3, 2> rectangleAxes(const glm::dvec3& direction) {
    const glm::dvec3 level = glm::cross(direction, glm::dvec3(0.0, 1.0, 0.0));
    const bool upright = glm::length(level) < 1e-6;
    const glm::dvec3 across = upright ? glm::dvec3(1.0, 0.0, 0.0) : glm::normalize(level);
    return {across, glm::normalize(glm::cross(across, direction))};
}

std::vector<Light> lightPoints(const Light& light, std::size_t count) {
    std::vector<Light> points;
    findLightPoints(light, count, points);
    return points;
}

void findLightPoints(const Light& light, std::size_t count, std::vector<Light>& points) {
    Light like = light;
    like.extent.reset();
    if (light.extent->shape == LightExtent::Shape::rectangle && !like.cone)
        like.cone = Cone{light.extent->direction, 0.0, std::numbers::pi / 2.0};
    points.clear();
    for (std::uint64_t n = 0; n < count; ++n)
        points.push_back(like.at(pointOf(light, n)));
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

LightRegion regionOf(const Light& light) {
    const LightExtent& extent = *light.extent;
    switch (extent.shape) {
    case LightExtent::Shape::disc:
        return {glm::dvec4(unitOf(glm::dvec3(light.position)), 0.0),
                2.0 * std::sin(0.5 * extent.radius)};
    case LightExtent::Shape::rectangle:
        return {light.position / light.position.w, 0.5 * glm::length(extent.size)};
    case LightExtent::Shape::sphere:
        break;
    }
    return {light.position / light.position.w, extent.radius};
}

LightBall ballInObject(const LightRegion& region, const glm::dmat4& worldFromObject) {
    constexpr double rounding = 1e-6;
    constexpr double everywhere = 1e30;
    glm::dvec4 center = glm::inverse(worldFromObject) * region.center;
    double radius = rangeInObject(region.radius, worldFromObject);
    if (region.center.w == 0.0) {
        // lightInObject() scales directions so: those `radius` apart come up to 1 + sqrt(3) times
        // as far apart, divided by the smaller one's largest component.
        const double largest = largestComponent(glm::dvec3(center));
        radius = radius < largest ? (1.0 + std::numbers::sqrt3) * radius / (largest - radius)
                                  : everywhere;
        center /= largest;
    }
    radius += rounding * (radius + glm::length(glm::dvec3(center)));
    return {glm::vec4(center), static_cast<float>(std::min(radius, everywhere))};
}

} // namespace edgeshade
