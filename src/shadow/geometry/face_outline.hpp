#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>

namespace edgeshade {

/// Directions from a light, by the faces of a cube around it: columns of a face are its u axis, v
/// axis and outward axis, and a direction lies on it at (u, v) in [-1, 1].
std::array<glm::dmat3, 6> directionFaces();

/// The face that holds three rays with some room to spare, as an index of directionFaces(); -1 if
/// there is none.
int faceAround(const std::array<glm::dvec3, 3>& rays);

/// A rectangle on a face that a triangle may lie in; low above high: nowhere.
struct Outline {
    double u0 = INFINITY, u1 = -INFINITY, v0 = INFINITY, v1 = -INFINITY;

    /// Takes in the point where a ray, in the face's axes and in front of the light, meets the
    /// face, rounding included.
    void add(const glm::dvec3& on) {
        constexpr double margin = 1e-9;
        const double u = on.x / on.z, v = on.y / on.z;
        const double reach = margin * (1.0 + std::abs(u) + std::abs(v));
        u0 = std::min(u0, u - reach);
        u1 = std::max(u1, u + reach);
        v0 = std::min(v0, v - reach);
        v1 = std::max(v1, v + reach);
    }
    bool misses(const Outline& other) const {
        return u1 < other.u0 || u0 > other.u1 || v1 < other.v0 || v0 > other.v1;
    }
    /// Whether it has no area.
    bool empty() const { return !(u0 < u1 && v0 < v1); }
};

/// Of a triangle, as rays from the light to its corners; never too small.
Outline outlineOn(const glm::dmat3& face, const std::array<glm::dvec3, 3>& rays);

} // namespace edgeshade
