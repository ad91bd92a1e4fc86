#include "src/render/separation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace edgeshade {
namespace {

/// Gaps below this share of the coordinates may be rounding: GL places things in floats.
constexpr double leastGap = 4e-6;

struct Interval {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void add(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

/// What a pyramid covers of an axis, and how large its coordinates are there.
struct Shade {
    Interval interval;
    double size = 0.0;
};

Shade shadeOf(const LightPyramid& pyramid, const glm::dvec3& axis) {
    Shade shade;
    const auto add = [&](const glm::dvec3& point) {
        shade.interval.add(glm::dot(axis, point));
        shade.size = std::max(shade.size, glm::dot(glm::abs(axis), glm::abs(point)));
    };
    for (const glm::dvec3& corner : pyramid.corners)
        add(corner);
    const glm::dvec3 light(pyramid.light);
    if (pyramid.light.w != 0.0) {
        add(light);
        return shade;
    }
    const double along = glm::dot(axis, light);
    const double rounding = leastGap * glm::dot(glm::abs(axis), glm::abs(light));
    if (along > -rounding) shade.interval.high = std::numeric_limits<double>::infinity();
    if (along < rounding) shade.interval.low = -std::numeric_limits<double>::infinity();
    return shade;
}

/// Whether what covers `other` of the axis, with coordinates up to `size`, is apart there.
bool separates(const LightPyramid& pyramid, const glm::dvec3& axis, const Interval& other,
               double size) {
    const Shade shade = shadeOf(pyramid, axis);
    const double gap = std::max(shade.interval.low - other.high, other.low - shade.interval.high);
    return gap > leastGap * std::max(size, shade.size);
}

/// Calls `separate` for axes of unit length until it says yes. Separating axes of convex sets are
/// normals of their faces and products of their edges; `edges` and `normals` are the other set's.
template <class Separate>
bool anyAxis(const LightPyramid& pyramid, std::span<const glm::dvec3> normals,
             std::span<const glm::dvec3> edges, Separate separate) {
    const auto tried = [&](const glm::dvec3& axis) {
        const double length = glm::length(axis);
        return length > 0.0 && std::isfinite(length) && separate(axis / length);
    };
    const auto& c = pyramid.corners;
    const glm::dvec3 light(pyramid.light);
    std::array<glm::dvec3, 6> own = {c[1] - c[0], c[3] - c[0]};
    for (std::size_t i = 0; i < 4; ++i)
        own[2 + i] = light - c[i] * pyramid.light.w;
    if (std::any_of(normals.begin(), normals.end(), tried)) return true;
    if (tried(glm::cross(own[0], own[1]))) return true;
    for (std::size_t i = 0; i < 4; ++i)
        if (tried(glm::cross(own[2 + i], c[(i + 1) % 4] - c[i]))) return true;
    for (const glm::dvec3& edge : own)
        for (const glm::dvec3& other : edges)
            if (tried(glm::cross(edge, other))) return true;
    return false;
}

} // namespace

bool areApart(const LightPyramid& pyramid, const Box& box) {
    if (box.empty()) return true;
    const std::array<glm::dvec3, 3> axes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    const glm::dvec3 center = box.center();
    const glm::dvec3 half = box.high - center;
    const glm::dvec3 largest = glm::max(glm::abs(box.low), glm::abs(box.high));
    return anyAxis(pyramid, axes, axes, [&](const glm::dvec3& axis) {
        const double at = glm::dot(axis, center), reach = glm::dot(glm::abs(axis), half);
        return separates(pyramid, axis, {at - reach, at + reach},
                         glm::dot(glm::abs(axis), largest));
    });
}

bool areApart(const LightPyramid& pyramid, const std::array<glm::dvec3, 3>& triangle) {
    const auto& [a, b, c] = triangle;
    const std::array<glm::dvec3, 3> edges = {b - a, c - b, a - c};
    const std::array<glm::dvec3, 1> normals = {glm::cross(edges[0], edges[1])};
    return anyAxis(pyramid, normals, edges, [&](const glm::dvec3& axis) {
        Interval interval;
        double size = 0.0;
        for (const glm::dvec3& corner : triangle) {
            interval.add(glm::dot(axis, corner));
            size = std::max(size, glm::dot(glm::abs(axis), glm::abs(corner)));
        }
        return separates(pyramid, axis, interval, size);
    });
}

} // namespace edgeshade
