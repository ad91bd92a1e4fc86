#include "src/city/caster_filter.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade::city {
namespace {

/// Squares along a side of a target, at most.
constexpr std::int64_t squaresAlong = 16;

/// A height that no surface is below; rounding moved them by less.
double lowestOf(std::span<const double> heights) {
    return std::ranges::min(heights) - latticeUnit;
}

} // namespace

CasterFilter::CasterFilter(const SunFan& fan, const CellRange& cells, double width,
                           std::span<const double> heights)
    : fan_(&fan), target_(cells, width, lowestOf(heights)) {
    const std::int64_t side =
        (std::max(cells.columns(), cells.rows()) + squaresAlong - 1) / squaresAlong;
    for (std::int64_t bottom = cells.bottom; bottom < cells.top; bottom += side)
        for (std::int64_t left = cells.left; left < cells.right; left += side) {
            const CellRange square{left, bottom, std::min(left + side, cells.right),
                                   std::min(bottom + side, cells.top)};
            double lowest = HUGE_VAL;
            for (std::int64_t y = square.bottom; y < square.top; ++y)
                lowest = std::min(
                    lowest, lowestOf(heights.subspan(
                                static_cast<std::size_t>((y - cells.bottom) * cells.columns() +
                                                         square.left - cells.left),
                                static_cast<std::size_t>(square.columns()))));
            if (lowest < HUGE_VAL) squares_.emplace_back(square, width, lowest);
        }
}

std::vector<double> CasterFilter::leastHeightsOf(std::span<const CityTriangle> triangles,
                                                 const PartSquares& squares) const {
    std::vector<Box> boxes(squares.count());
    for (const CityTriangle& triangle : triangles) {
        const Box box = triangle.box();
        boxes[squares.squareOf(box)].add(box);
    }
    std::vector<double> heights(boxes.size(), HUGE_VAL);
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (const TargetBox& square : squares_)
            if (!boxes[i].empty())
                heights[i] = std::min(heights[i], fan_->leastHeight(boxes[i], square));
    return heights;
}

} // namespace edgeshade::city
