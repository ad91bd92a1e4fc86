#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <span>

namespace edgeshade {

/// The faces of a cube around a light. A face's columns are its u axis, v axis and outward axis,
/// and a direction lies on it at (u, v) in [-1, 1].
std::array<glm::dmat3, 6> directionFaces();

/// The index in directionFaces() of the face that holds a ray with a margin; -1 if there is none.
inline int faceAround(const glm::dvec3& ray) {
    constexpr double roomToSpare = 0.999; // share of a face's half side
    const glm::dvec3 lengths = glm::abs(ray);
    int axis = lengths.x >= lengths.y ? 0 : 1;
    double largest = std::max(lengths.x, lengths.y);
    if (lengths.z > largest) axis = 2;
    largest = std::max(largest, lengths.z);
    const double reach = roomToSpare * largest;
    const int others = (lengths.x < reach) + (lengths.y < reach) + (lengths.z < reach);
    const double along = axis == 0 ? ray.x : axis == 1 ? ray.y : ray.z;
    return others == 2 ? 2 * axis + (along < 0.0 ? 1 : 0) : -1;
}

/// A rectangle on a face that may contain a triangle; empty if low is above high.
struct Outline {
    double u0 = INFINITY, u1 = -INFINITY, v0 = INFINITY, v1 = -INFINITY;

    void add(const Outline& other) {
        u0 = std::min(u0, other.u0);
        u1 = std::max(u1, other.u1);
        v0 = std::min(v0, other.v0);
        v1 = std::max(v1, other.v1);
    }
    bool misses(const Outline& other) const {
        return u1 < other.u0 || u0 > other.u1 || v1 < other.v0 || v0 > other.v1;
    }
    /// Whether its area is zero.
    bool empty() const { return !(u0 < u1 && v0 < v1); }
};

/// A convex polygon on a face, by the (u, v) of its corners in cyclic order.
struct FacePolygon {
    std::array<glm::dvec2, 8> corners{};
    std::size_t count = 0; ///< 0: empty

    void add(const glm::dvec2& corner) { corners[count++] = corner; }
    std::span<const glm::dvec2> all() const { return {corners.data(), count}; }
};

/// The bounding rectangle of points on a face.
inline Outline outlineOf(std::span<const glm::dvec2> points) {
    Outline outline;
    for (const glm::dvec2& point : points)
        outline.add({point.x, point.x, point.y, point.y});
    return outline;
}

/// The polygon on the face that may contain a triangle, given as rays from the light to its
/// corners. It may extend slightly beyond the face's borders, and is the whole face if the triangle
/// is at the light.
FacePolygon polygonOn(const glm::dmat3& face, const std::array<glm::dvec3, 3>& rays);

} // namespace edgeshade
