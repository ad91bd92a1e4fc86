#pragma once

#include "src/city/city_tile.hpp"
#include "src/shadow/geometry/box_tree.hpp"

#include <span>

namespace edgeshade::city {

/// Triangles of a source that are near each other.
struct Part {
    Box box;
    std::uint64_t triangles = 0;
    std::size_t source = 0; ///< in Plan::sources
};

/// Squares of a grid over a source: of 64 m, or wider, so that no side has more than 16.
class PartSquares {
  public:
    explicit PartSquares(std::span<const CityTriangle> triangles);

    std::size_t count() const;
    /// The square that the middle of a triangle's box is in, below count().
    std::size_t squareOf(const Box& triangle) const;

  private:
    Box all_;
    double width_ = 0.0; ///< metres
};

/// Divides a source's triangles by the squares of a grid. Squares without triangles are left out.
std::vector<Part> partsOf(std::span<const CityTriangle> triangles, std::size_t source);

/// Boxes of boxes around the parts of a city.
class PartTree {
  public:
    explicit PartTree(std::vector<Part> parts);

    /// Calls use(part) for each part whose box is accepted. `accept(box)`: must accept a box that
    /// holds one that it accepts.
    template <class Accept, class Use>
    void forEach(const Accept& accept, const Use& use) const {
        for (std::size_t i = 0; boxes_.levels() > 0 && i < boxes_.count(boxes_.levels() - 1); ++i)
            search(boxes_.levels() - 1, i, accept, use);
    }

  private:
    Box boxOf(std::size_t level, std::size_t number) const {
        constexpr std::size_t arity = BoxTree<double>::arity;
        const FourBoxes<double>& group = boxes_.group(level, number / arity);
        const std::size_t lane = number % arity;
        return {{group.low[0][lane], group.low[1][lane], group.low[2][lane]},
                {group.high[0][lane], group.high[1][lane], group.high[2][lane]}};
    }

    template <class Accept, class Use>
    void search(std::size_t level, std::size_t number, const Accept& accept, const Use& use) const {
        if (!accept(boxOf(level, number))) return;
        if (level == 0) return use(parts_[number]);
        const std::size_t first = number * BoxTree<double>::arity,
                          end = std::min(first + BoxTree<double>::arity, boxes_.count(level - 1));
        for (std::size_t below = first; below < end; ++below)
            search(level - 1, below, accept, use);
    }

    std::vector<Part> parts_; ///< in the order of the tree's items
    BoxTree<double> boxes_;
};

} // namespace edgeshade::city
