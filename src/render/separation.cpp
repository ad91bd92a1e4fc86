#include "src/render/separation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

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

bool separates(const glm::dvec3& axis, const LightPyramid& pyramid, const Box& box) {
    Interval of;
    double size = 0.0;
    const auto add = [&](const glm::dvec3& point) {
        of.add(glm::dot(axis, point));
        size = std::max(size, glm::dot(glm::abs(axis), glm::abs(point)));
    };
    for (const glm::dvec3& corner : pyramid.corners)
        add(corner);
    const glm::dvec3 light(pyramid.light);
    if (pyramid.light.w != 0.0) {
        add(light);
    } else {
        const double along = glm::dot(axis, light);
        const double rounding = leastGap * glm::dot(glm::abs(axis), glm::abs(light));
        if (along > -rounding) of.high = std::numeric_limits<double>::infinity();
        if (along < rounding) of.low = -std::numeric_limits<double>::infinity();
    }
    const glm::dvec3 center = box.center();
    const double at = glm::dot(axis, center);
    const double reach = glm::dot(glm::abs(axis), box.high - center);
    size =
        std::max(size, glm::dot(glm::abs(axis), glm::max(glm::abs(box.low), glm::abs(box.high))));
    const double gap = std::max(of.low - (at + reach), (at - reach) - of.high);
    return gap > leastGap * size && size > 0.0;
}

} // namespace

bool areApart(const LightPyramid& pyramid, const Box& box) {
    if (box.empty()) return true;
    const auto& c = pyramid.corners;
    // Separating axes of convex sets: normals of their faces, and products of their edges.
    std::vector<glm::dvec3> edges = {c[1] - c[0], c[3] - c[0]};
    const glm::dvec3 light(pyramid.light);
    for (const glm::dvec3& corner : c)
        edges.push_back(light - corner * pyramid.light.w);
    std::vector<glm::dvec3> axes = {
        {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, glm::cross(edges[0], edges[1])};
    for (std::size_t i = 0; i < 4; ++i)
        axes.push_back(glm::cross(edges[2 + i], c[(i + 1) % 4] - c[i]));
    for (const glm::dvec3& edge : edges)
        for (const glm::dvec3& of : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)})
            axes.push_back(glm::cross(edge, of));
    return std::any_of(axes.begin(), axes.end(), [&](const glm::dvec3& axis) {
        const double length = glm::length(axis);
        return length > 0.0 && std::isfinite(length) && separates(axis / length, pyramid, box);
    });
}

} // namespace edgeshade
