#include "src/shadow/geometry/light_region.hpp"

#include "src/shadow/geometry/vectors.hpp"

#include <numbers>

namespace edgeshade {
namespace {

/// Of an extent: what rounding may place within it.
constexpr double safeShare = 0.999;

constexpr double mostOfSun = 0.3 * std::numbers::pi / 180.0; ///< radians
constexpr double mostOfLamp = 0.002;                         ///< of the scene's diagonal

} // namespace

double placesApart(const glm::dvec4& a, const glm::dvec4& b) {
    if ((a.w == 0.0) != (b.w == 0.0)) return std::numeric_limits<double>::infinity();
    if (a.w != 0.0) return glm::length(glm::dvec3(a) / a.w - glm::dvec3(b) / b.w);
    const glm::dvec3 u = unitOf(glm::dvec3(a)), v = unitOf(glm::dvec3(b));
    return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
}

double mostWander(const Light& light, double sceneSize) {
    return light.position.w == 0.0 ? mostOfSun : mostOfLamp * sceneSize;
}

Light anywhereWithin(const Light& light, double radius) {
    Light region = light;
    region.extent.emplace();
    region.extent->shape =
        light.position.w == 0.0 ? LightExtent::Shape::disc : LightExtent::Shape::sphere;
    region.extent->radius = radius;
    return region;
}

bool isWithin(const Light& light, const Light& region, double share) {
    if (light.range != region.range) return false;
    if (light.position == region.position) return true;
    return region.extent && placesApart(light.position, region.position) <=
                                safeShare * share * region.extent->radius;
}

} // namespace edgeshade
