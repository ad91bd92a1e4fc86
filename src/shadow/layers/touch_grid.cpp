#include "src/shadow/layers/touch_grid.hpp"

namespace edgeshade {
namespace {

constexpr double placing = 1e-9;   // relative rounding of coordinates on a face
constexpr double levelEdge = 1e-6; // cells: an edge that rises by less has no reliable slope

} // namespace

void TouchGrid::begin(const Outline& part, int depth) {
    side_ = 1 << depth;
    low_ = {part.u0, part.v0};
    perUnit_ = {side_ / (part.u1 - part.u0), side_ / (part.v1 - part.v0)};
    counts_.assign(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_ + 1), 0);
    const double size = 1.0 + std::max(std::abs(part.u0), std::abs(part.u1)) +
                        std::max(std::abs(part.v0), std::abs(part.v1));
    rounding_ = placing * size * std::max(perUnit_.x, perUnit_.y);
}

TouchGrid::Edge TouchGrid::edgeBetween(const glm::dvec2& a, const glm::dvec2& b) {
    if (a.y > b.y) return edgeBetween(b, a);
    return {a, b, b.y - a.y > levelEdge ? (b.x - a.x) / (b.y - a.y) : 0.0};
}

TouchGrid::Span TouchGrid::crossedBy(std::span<const Edge> edges, double border) const {
    Span span;
    for (const Edge& edge : edges) {
        if (border < edge.from.y - rounding_ || border > edge.to.y + rounding_) continue;
        const double left = std::min(edge.from.x, edge.to.x);
        const double right = std::max(edge.from.x, edge.to.x);
        const bool level = edge.to.y - edge.from.y <= levelEdge;
        const double at = edge.from.x + (border - edge.from.y) * edge.slope;
        const double reach = level ? right - left : rounding_ * std::abs(edge.slope);
        span.add(std::clamp(at - reach, left, right));
        span.add(std::clamp(at + reach, left, right));
    }
    return span;
}

std::optional<TouchGrid::Range> TouchGrid::rangeOf(const Outline& outline) const {
    const glm::dvec2 least = (glm::dvec2(outline.u0, outline.v0) - low_) * perUnit_;
    const glm::dvec2 most = (glm::dvec2(outline.u1, outline.v1) - low_) * perUnit_;
    if (misses(least.x, most.x) || misses(least.y, most.y)) return std::nullopt;
    return Range{place(least.x - rounding_), place(most.x + rounding_), place(least.y - rounding_),
                 place(most.y + rounding_)};
}

void TouchGrid::add(const TouchGrid& other) {
    for (std::size_t i = 0; i < counts_.size(); ++i)
        counts_[i] += other.counts_[i];
}

void TouchGrid::sum() {
    for (int row = 0; row < side_; ++row)
        for (int column = 1; column < side_; ++column)
            at(row, column) += at(row, column - 1);
}

Outline TouchGrid::cell(int row, int column) const {
    const glm::dvec2 low = low_ + glm::dvec2(column, row) / perUnit_;
    const glm::dvec2 high = low_ + glm::dvec2(column + 1, row + 1) / perUnit_;
    return {low.x, high.x, low.y, high.y};
}

} // namespace edgeshade
