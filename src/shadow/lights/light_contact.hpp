#pragma once

#include "preprocess/base/box.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>

namespace edgeshade {

/// Contact of a light with a triangle that it is in, or nearly in. Everything is in the space of
/// the triangle's batch, with its positions as floats (docs/method.md, C47).
struct LightContact {
    /// Sine of the angle below which a light only grazes a triangle and doesn't light it. It is two
    /// seconds of arc, more than rounding may rotate a wall parallel to a sun.
    static constexpr double grazingSine = 1e-5;

    /// The light is a point on the triangle: no farther from it than rounding may have moved
    /// either. The triangle then has no extent as seen from the light, and casts nothing.
    bool touches = false;
    /// The light touches the triangle or sees it edge-on, and doesn't light its surface.
    bool grazes = false;
    /// Distance from the triangle's plane, with unit normal, at which a device's floats may place a
    /// touching light; 0 if it doesn't touch.
    double reach = 0.0;
};

/// `light`: homogeneous (docs/method.md, Terms). Triangles without an area have no contact.
/// `mantissaBits`: of the device's floats.
LightContact contactOf(const std::array<glm::dvec3, 3>& corners, const glm::dvec4& light,
                       int mantissaBits = 23);

/// Whether a directional light grazes a triangle. `normal`: the triangle's, of length 1; `light`:
/// towards the light, any length but 0. Both in the batch's space.
inline bool grazesFrom(const glm::dvec3& normal, const glm::dvec3& light) {
    return std::abs(glm::dot(normal, light)) <= LightContact::grazingSine * glm::length(light);
}

/// Whether a point light touches the triangle.
inline bool touches(const std::array<glm::dvec3, 3>& corners, const glm::dvec4& light) {
    return light.w != 0.0 && contactOf(corners, light).touches;
}

/// Whether a point light may touch a triangle within the box.
bool mayTouch(const Box& box, const glm::dvec4& light, int mantissaBits = 23);

/// The largest LightContact::reach of the triangles that a point light touches; 0 if there are
/// none. `indices`: three per triangle.
double contactReachOf(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                      const glm::dvec4& light);

} // namespace edgeshade
