#pragma once

#include "tests/support/headless.hpp"

namespace edgeshade::test {

inline Light sphereAt(const glm::dvec3& place, double radius) {
    Light light = pointLight(place);
    light.extent = {.shape = LightExtent::Shape::sphere, .radius = radius};
    return light;
}

/// `direction`: that it faces, of length 1.
inline Light panelAt(const glm::dvec3& place, const glm::dvec2& size, const glm::dvec3& direction) {
    Light light = pointLight(place);
    light.extent = {.shape = LightExtent::Shape::rectangle, .size = size, .direction = direction};
    return light;
}

/// `degrees`: the disc's diameter.
inline Light discTowards(const glm::dvec3& towards, double degrees) {
    Light light = sun(towards);
    light.extent = {.shape = LightExtent::Shape::disc, .radius = 0.5 * glm::radians(degrees)};
    return light;
}

} // namespace edgeshade::test
