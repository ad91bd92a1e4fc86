#include "src/engine/host_lights.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/base/vectors.hpp"

#include <cmath>
#include <numbers>
#include <string>

namespace edgeshade {
namespace {

glm::dvec3 vectorOf(const std::array<double, 3>& numbers) {
    return {numbers[0], numbers[1], numbers[2]};
}

Light lightOf(const MaskLight& from, const std::string& name) {
    const auto require = [&](bool holds, const std::string& what) {
        if (!holds) throw InputError(name + " " + what + ".");
    };
    const bool isSun = from.kind == MaskLight::Kind::directional;
    const glm::dvec3 position = vectorOf(from.position), shines = vectorOf(from.direction);
    require(isSun || isFinite(position), "has a position that is not finite");
    const bool turned =
        from.kind == MaskLight::Kind::point || (isFinite(shines) && glm::length(shines) > 0.0);
    require(turned, "has no direction");
    require(from.radius >= 0.0 && std::isfinite(from.radius), "has a radius below 0");
    Light light;
    if (isSun) {
        light.position = glm::dvec4(-glm::normalize(shines), 0.0);
        require(from.radius <= std::numbers::pi / 4.0, "has a radius above pi/4");
        if (from.radius > 0.0)
            light.extent = LightExtent{.shape = LightExtent::Shape::disc, .radius = from.radius};
        return light;
    }
    require(from.range > 0.0, "has no range above 0");
    light.position = glm::dvec4(position, 1.0);
    light.range = from.range;
    if (from.radius > 0.0)
        light.extent = LightExtent{.shape = LightExtent::Shape::sphere, .radius = from.radius};
    if (from.kind == MaskLight::Kind::point) return light;
    require(from.outerAngle > 0.0 && from.outerAngle <= std::numbers::pi / 2.0,
            "has an outer angle that is not above 0 and at most pi/2");
    light.cone = Cone{.axis = glm::normalize(shines), .inner = 0.0, .outer = from.outerAngle};
    return light;
}

} // namespace

std::vector<Light> lightsOf(std::span<const MaskLight> lights) {
    std::vector<Light> result;
    for (std::size_t i = 0; i < lights.size(); ++i)
        result.push_back(lightOf(lights[i], "Light " + std::to_string(i)));
    return result;
}

} // namespace edgeshade
