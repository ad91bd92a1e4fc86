#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>

namespace edgeshade {

/// A convex polygon: a triangle clipped by at most five planes.
struct Polygon {
    std::array<glm::dvec3, 8> corners;
    std::size_t count = 0;

    void add(const glm::dvec3& corner) { corners[count++] = corner; }
};

/// Keeps the part of the polygon where dot(normal, p) + offset >= 0 (Sutherland-Hodgman).
inline Polygon clipped(const Polygon& polygon, const glm::dvec3& normal, double offset = 0.0) {
    Polygon kept;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const glm::dvec3& here = polygon.corners[i];
        const glm::dvec3& next = polygon.corners[(i + 1) % polygon.count];
        const double a = glm::dot(normal, here) + offset;
        const double b = glm::dot(normal, next) + offset;
        if (a >= 0.0) kept.add(here);
        if ((a >= 0.0) != (b >= 0.0)) kept.add(here + (next - here) * (a / (a - b)));
    }
    return kept;
}

} // namespace edgeshade
