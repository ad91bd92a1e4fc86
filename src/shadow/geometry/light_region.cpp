#include "src/shadow/geometry/light_region.hpp"

#include "src/shadow/geometry/vectors.hpp"

namespace edgeshade {
namespace {

/// Of an extent: what rounding may place within it.
constexpr double safeShare = 0.999;

/// Radians between directional lights, units between others.
double distanceOf(const glm::dvec4& a, const glm::dvec4& b) {
    if (a.w != 0.0) return glm::length(glm::dvec3(a) / a.w - glm::dvec3(b) / b.w);
    const glm::dvec3 u = unitOf(glm::dvec3(a)), v = unitOf(glm::dvec3(b));
    return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
}

} // namespace

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
    return region.extent && (light.position.w == 0.0) == (region.position.w == 0.0) &&
           distanceOf(light.position, region.position) <=
               safeShare * share * region.extent->radius;
}

} // namespace edgeshade
