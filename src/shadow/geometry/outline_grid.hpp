#pragma once

#include "src/shadow/geometry/face_outline.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace edgeshade {

/// A rectangle on a face in equal cells, and how many outlines may touch each.
class OutlineGrid {
  public:
    static constexpr int depth = 9; ///< halvings of the rectangle's sides
    static constexpr int side = 1 << depth;

    OutlineGrid(const Outline& part, std::span<const Outline> outlines);

    struct Range {
        int i0, i1, j0, j1; ///< cells, last ones included
    };

    /// The cells that an outline may touch; nothing if it misses the rectangle.
    std::optional<Range> rangeOf(const Outline& outline) const;

    std::size_t count(int i, int j) const {
        return static_cast<std::size_t>(counts_[static_cast<std::size_t>(j) * (side + 1) + i]);
    }
    /// Of all cells.
    std::size_t largestCount() const;

    Outline cell(int i, int j) const;

  private:
    int& at(int i, int j) { return counts_[static_cast<std::size_t>(j) * (side + 1) + i]; }

    Outline part_;
    std::vector<int> counts_;
};

/// The part of a rectangle that outlines reach; empty() where they don't.
Outline reachedPart(const Outline& whole, std::span<const Outline> outlines);

} // namespace edgeshade
