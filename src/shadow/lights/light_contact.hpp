#pragma once

#include "preprocess/base/box.hpp"

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>

namespace edgeshade {

/// How a light lies to a triangle that it is in, or nearly in. All in the space of the triangle's
/// batch, whose positions are the floats at hand (docs/method.md, C47).
struct LightContact {
    /// Sine of the angle below which a light only grazes a triangle and doesn't light it: two
    /// seconds of arc, above what rounding may turn a wall that a sun is parallel to.
    static constexpr double grazingSine = 1e-5;

    /// The light is a point, and no farther from the triangle than rounding may have moved either:
    /// it lies on it. Then the triangle has no extent as seen from it, and casts nothing.
    bool touches = false;
    /// It touches, or sees the triangle from its edge: it doesn't light its surface.
    bool grazes = false;
    /// How far from the triangle's plane, of unit normal, a device's floats may place a light that
    /// touches it; 0 if it doesn't.
    double reach = 0.0;
};

/// `light`: homogeneous (docs/method.md, Terms). Triangles without an area are not in contact with
/// anything. `mantissaBits`: of the device's floats.
LightContact contactOf(const std::array<glm::dvec3, 3>& corners, const glm::dvec4& light,
                       int mantissaBits = 23);

/// Whether a point light touches the triangle.
inline bool touches(const std::array<glm::dvec3, 3>& corners, const glm::dvec4& light) {
    return light.w != 0.0 && contactOf(corners, light).touches;
}

/// Whether a point light may touch something within the box.
bool mayTouch(const Box& box, const glm::dvec4& light, int mantissaBits = 23);

/// The farthest LightContact::reach of the triangles that a point light touches; 0 where there is
/// none. `indices`: three a triangle.
double contactReachOf(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                      const glm::dvec4& light);

} // namespace edgeshade
