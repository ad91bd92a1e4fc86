#pragma once

#include "src/shadow/lights/face_outline.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

namespace edgeshade {

/// A rectangle on a face in equal cells, and the number of polygons that may touch each cell.
/// Counts are never too low: in each row a polygon covers everything between its leftmost and its
/// rightmost point. Call add() for all polygons, then sum().
class TouchGrid {
  public:
    TouchGrid() = default;
    TouchGrid(const Outline& part, int depth) { begin(part, depth); }

    /// Divides the rectangle, which must have an area, in 2^depth x 2^depth empty cells. Keeps its
    /// memory.
    void begin(const Outline& part, int depth);

    /// Calls visit(row, first column, last column) for all cells that a convex polygon may touch.
    template <class Visit>
    void forEachSpan(std::span<const glm::dvec2> polygon, Visit visit) const;

    void add(std::span<const glm::dvec2> polygon) {
        forEachSpan(polygon, [&](int row, int left, int right) { addSpan(row, left, right); });
    }
    /// Counts all cells of an outline, which is faster than for the polygon in it.
    void add(const Outline& outline) {
        if (const auto range = rangeOf(outline))
            for (int row = range->bottom; row <= range->top; ++row)
                addSpan(row, range->left, range->right);
    }
    /// Adds another grid of the same cells; neither may be summed yet.
    void add(const TouchGrid& other);
    void sum();

    int side() const { return side_; }
    std::size_t count(int row, int column) const {
        return static_cast<std::size_t>(counts_[indexOf(row, column)]);
    }
    Outline cell(int row, int column) const;

  private:
    struct Range {
        int left, right, bottom, top; ///< columns and rows, last ones included
    };
    /// Null if it misses the rectangle.
    std::optional<Range> rangeOf(const Outline& outline) const;

    /// An edge in cell coordinates, from bottom to top.
    struct Edge {
        glm::dvec2 from, to;
        double slope; ///< horizontal cells per vertical cell; 0 if nearly level
    };
    static Edge edgeBetween(const glm::dvec2& a, const glm::dvec2& b);
    struct Span {
        double low = INFINITY, high = -INFINITY;
        void add(double at) {
            low = std::min(low, at);
            high = std::max(high, at);
        }
    };
    /// The span in which edges may cross a row's border.
    Span crossedBy(std::span<const Edge> edges, double border) const;

    std::size_t indexOf(int row, int column) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(side_ + 1) +
               static_cast<std::size_t>(column);
    }
    std::int32_t& at(int row, int column) { return counts_[indexOf(row, column)]; }
    bool misses(double low, double high) const {
        return high < -rounding_ || low > side_ + rounding_;
    }
    void addSpan(int row, int left, int right) {
        at(row, left) += 1;
        at(row, right + 1) -= 1;
    }
    int place(double cells) const {
        return static_cast<int>(std::clamp(cells, 0.0, static_cast<double>(side_ - 1)));
    }

    int side_ = 1;
    glm::dvec2 low_{0.0}, perUnit_{1.0}; ///< its first corner, and cells per unit
    double rounding_ = 0.0;              ///< of coordinates, in cells
    std::vector<std::int32_t> counts_;
};

template <class Visit>
void TouchGrid::forEachSpan(std::span<const glm::dvec2> polygon, Visit visit) const {
    const auto range = rangeOf(outlineOf(polygon));
    if (!range) return;
    if (range->bottom == range->top || range->right - range->left < 2) {
        for (int row = range->bottom; row <= range->top; ++row)
            visit(row, range->left, range->right);
        return;
    }
    FacePolygon cells;
    for (const glm::dvec2& corner : polygon)
        cells.add((corner - low_) * perUnit_);
    std::array<Edge, 8> all;
    for (std::size_t i = 0; i < cells.count; ++i)
        all[i] = edgeBetween(cells.corners[i], cells.corners[(i + 1) % cells.count]);
    const std::span<const Edge> edges(all.data(), cells.count);
    Span below = crossedBy(edges, range->bottom);
    for (int row = range->bottom; row <= range->top; ++row) {
        const Span above = crossedBy(edges, row + 1.0);
        Span span{std::min(below.low, above.low), std::max(below.high, above.high)};
        for (const glm::dvec2& corner : cells.all())
            if (corner.y >= row - rounding_ && corner.y <= row + 1.0 + rounding_)
                span.add(corner.x);
        if (!misses(span.low, span.high))
            visit(row, place(span.low - rounding_), place(span.high + rounding_));
        below = above;
    }
}

} // namespace edgeshade
