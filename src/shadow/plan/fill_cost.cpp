#include "src/shadow/plan/fill_cost.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace edgeshade {
namespace {

constexpr double tileSide = 64.0, blockSide = 4.0;

/// A convex polygon in clip space: a triangle after clipping by at most five planes.
struct ClipPolygon {
    std::array<glm::dvec4, 8> corners;
    std::size_t count = 0;
};

/// Keeps the part where dot(plane, p) >= 0 (Sutherland-Hodgman).
void clip(ClipPolygon& polygon, const glm::dvec4& plane) {
    std::array<double, 8> heights;
    bool all = true;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        heights[i] = glm::dot(plane, polygon.corners[i]);
        all = all && heights[i] >= 0.0;
    }
    if (all) return;
    ClipPolygon kept;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const std::size_t j = (i + 1) % polygon.count;
        const glm::dvec4 &here = polygon.corners[i], &next = polygon.corners[j];
        if (heights[i] >= 0.0) kept.corners[kept.count++] = here;
        if ((heights[i] >= 0.0) != (heights[j] >= 0.0))
            kept.corners[kept.count++] =
                here + (next - here) * (heights[i] / (heights[i] - heights[j]));
    }
    polygon = kept;
}

/// Mean number of grid cells that a convex polygon meets over all positions, given its area and the
/// size of its box: the area of the polygon's Minkowski sum with a cell, in cells.
double cellsMet(double area, const glm::dvec2& size, double side) {
    return 1.0 + (size.x + size.y) / side + area / (side * side);
}

} // namespace

FillCost& FillCost::operator+=(const FillCost& other) {
    triangles += other.triangles;
    tilePairs += other.tilePairs;
    blocks += other.blocks;
    fragments += other.fragments;
    return *this;
}

FillCost FillCost::times(double factor) const {
    return {factor * triangles, factor * tilePairs, factor * blocks, factor * fragments};
}

FillMeter::FillMeter(const glm::dmat4& clipFromObject, int width, int height,
                     const PixelRectangle& open)
    : halfSize_(0.5 * open.width, 0.5 * open.height) {
    const glm::dvec2 size(width, height);
    const glm::dvec2 middle =
        2.0 * (glm::dvec2(open.x, open.y) + halfSize_) / size - glm::dvec2(1.0);
    const glm::dvec2 scale = size / glm::max(2.0 * halfSize_, glm::dvec2(1.0));
    glm::dmat4 openFromClip(1.0);
    for (glm::length_t i = 0; i < 2; ++i) {
        openFromClip[i][i] = scale[i];
        openFromClip[3][i] = -middle[i] * scale[i];
    }
    openFromObject_ = openFromClip * clipFromObject;
}

FillCost FillMeter::of(const std::array<glm::dvec4, 3>& corners, bool nearCuts) const {
    ClipPolygon polygon;
    for (const glm::dvec4& corner : corners)
        polygon.corners[polygon.count++] = openFromObject_ * corner;
    if (nearCuts) clip(polygon, {0, 0, 1, 1});
    for (const glm::dvec4& side :
         {glm::dvec4(1, 0, 0, 1), {-1, 0, 0, 1}, {0, 1, 0, 1}, {0, -1, 0, 1}})
        clip(polygon, side);
    FillCost cost;
    if (polygon.count < 3) return cost;
    glm::dvec2 low(INFINITY), high(-INFINITY);
    std::array<glm::dvec2, 8> points;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const glm::dvec4& p = polygon.corners[i];
        points[i] = p.w > 0.0 ? halfSize_ * glm::dvec2(p) / p.w : glm::dvec2(0.0);
        low = glm::min(low, points[i]);
        high = glm::max(high, points[i]);
    }
    double twice = 0.0;
    for (std::size_t i = 1; i + 1 < polygon.count; ++i) {
        const glm::dvec2 a = points[i] - points[0], b = points[i + 1] - points[0];
        twice += a.x * b.y - a.y * b.x;
    }
    const glm::dvec2 size = high - low;
    cost.triangles = 1.0;
    cost.fragments = 0.5 * std::abs(twice);
    cost.tilePairs = cellsMet(cost.fragments, size, tileSide);
    cost.blocks = cellsMet(cost.fragments, size, blockSide);
    return cost;
}

} // namespace edgeshade
