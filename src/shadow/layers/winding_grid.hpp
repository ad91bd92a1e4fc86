#pragma once

#include "src/shadow/layers/face_chain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace edgeshade {

/// A rectangle on a light's face in equal cells. It bounds how many triangles lines through each
/// cell meet: the winding number of the chain at the cell's lower left corner, and the most by
/// which it grows along the left border and from there across the paths that touch the cell
/// (docs/method.md, C48). Call add() with all segments that touch the rectangle, then sum(). It
/// computes in floats, four segments at once.
class WindingGrid {
  public:
    WindingGrid() = default;
    WindingGrid(const Outline& part, int depth, double error) { begin(part, depth, error); }

    /// Divides the rectangle, which must have an area, in 2^depth x 2^depth empty cells. `error`:
    /// as of FaceChain. Keeps its memory.
    void begin(const Outline& part, int depth, double error);

    /// Sets `places`, one per segment: the index, row * side() + column, of the only cell that it
    /// may touch; or inSquare(cell), if that is true of a cell with the next ones to the right,
    /// above, and to the right of that; or elsewhere(), if it may touch others or none, or if that
    /// isn't known.
    void add(std::span<const FaceSegment> segments, std::vector<int>& places);

    static constexpr int inSquare(int cell) { return ~cell; } ///< its own inverse
    int elsewhere() const { return inSquare(side_ * side_); }
    /// `start`: the count just below and to the left of the rectangle's lower left corner. It is
    /// raised by the weights of segments that may be on either side of that corner, unless it
    /// `isRaised` already: it comes from a coarser grid that has the same first corner.
    void sum(int start, bool isRaised = false);

    int side() const { return side_; }
    /// The count at a cell's lower left corner, for a chain that is bent by no more than rounding.
    int corner(int row, int column) const { return cells_[at(row, column)].corner; }
    /// No line through the cell meets more triangles.
    int bound(int row, int column) const {
        const Cell& cell = cells_[at(row, column)];
        return cell.corner + cell.growth;
    }
    Outline cell(int row, int column) const;

    /// Some rows and columns of cells, each from first to last.
    struct Cells {
        int bottom, top, left, right;
    };
    /// The rows and columns of all cells that a segment may touch; null if there are none.
    std::optional<Cells> cellsAround(const FaceSegment& segment) const {
        const Piece piece = inCells(segment);
        if (misses(piece)) return std::nullopt;
        return Cells{place(piece.from.y - rounding_), place(piece.to.y + rounding_),
                     place(piece.left - rounding_), place(piece.right + rounding_)};
    }
    /// Calls visit(row, first column, last column) for all cells that a segment may touch.
    template <class Visit>
    void forEachSpan(const FaceSegment& segment, Visit visit) const {
        const Piece piece = inCells(segment);
        if (!misses(piece)) forEachSpan(piece, piece.slope(), visit);
    }

  private:
    struct Cell {
        int corner = 0; ///< until sum(): the growth from the corner before
        int growth = 0; ///< the most by which a count in the cell exceeds the corner's
    };

    /// A segment in cells, upwards.
    struct Piece {
        glm::vec2 from, to;
        float left, right; ///< least and largest x
        int weight, starts;
        bool level;

        /// Horizontal cells per vertical cell; 0 if it is nearly level.
        float slope() const {
            const float rise = to.y - from.y;
            return rise > levelSegment ? (to.x - from.x) / rise : 0.0f;
        }
        /// Its x at a height between its ends.
        float at(float y, float slope) const {
            return std::clamp(from.x + (y - from.y) * slope, left, right);
        }
    };
    Piece inCells(const FaceSegment& segment) const {
        const glm::vec2 from = (segment.from - low_) * perUnit_;
        const glm::vec2 to = (segment.to - low_) * perUnit_;
        return {from,
                to,
                std::min(from.x, to.x),
                std::max(from.x, to.x),
                segment.weight,
                segment.starts,
                segment.level};
    }
    bool misses(const Piece& piece) const {
        const float end = static_cast<float>(side_) + rounding_;
        return piece.to.y < -rounding_ || piece.from.y > end || piece.right < -rounding_ ||
               piece.left > end;
    }
    template <class Visit>
    void forEachSpan(const Piece& piece, float slope, Visit visit) const;
    void addAcross(std::span<const FaceSegment> segments, const std::uint32_t* four,
                   std::vector<int>& places);
    void addAcross(const Piece& piece);
    void addCrossings(const Piece& piece, float slope);
    void addGrowth(const Piece& piece, float slope);

    std::size_t at(int row, int column) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(side_) +
               static_cast<std::size_t>(column);
    }
    int place(float cells) const {
        return static_cast<int>(std::clamp(cells, 0.0f, static_cast<float>(side_ - 1)));
    }

    /// Cells: a segment that rises by less has no reliable slope.
    static constexpr float levelSegment = 0x1p-14f;

    int depth_ = 0, side_ = 1;
    glm::vec2 low_{0.0f}, perUnit_{1.0f}; ///< its first corner, and cells per unit
    float rounding_ = 0.0f;               ///< distance from a segment to its exact place, in cells
    int atStart_ = 0;                     ///< weights of segments next to the first corner
    /// By row: how much larger the count to the left of the rectangle is than in the row below.
    std::vector<int> border_;
    std::vector<Cell> cells_;           ///< row by row
    std::vector<std::uint32_t> across_; ///< scratch: segments that may touch several cells, or none
};

template <class Visit>
void WindingGrid::forEachSpan(const Piece& piece, float slope, Visit visit) const {
    const int bottom = place(piece.from.y - rounding_), top = place(piece.to.y + rounding_);
    if (bottom == top || slope == 0.0f) {
        const int left = place(piece.left - rounding_), right = place(piece.right + rounding_);
        for (int row = bottom; row <= top; ++row)
            visit(row, left, right);
        return;
    }
    const float slack = rounding_ * (1.0f + std::abs(slope));
    const auto at = [&](int row) {
        return piece.at(std::clamp(static_cast<float>(row), piece.from.y, piece.to.y), slope);
    };
    float below = at(bottom);
    for (int row = bottom; row <= top; ++row) {
        const float above = at(row + 1);
        const float left = std::max(std::min(below, above) - slack, piece.left);
        const float right = std::min(std::max(below, above) + slack, piece.right);
        below = above;
        if (right < -rounding_ || left > static_cast<float>(side_) + rounding_) continue;
        visit(row, place(left - rounding_), place(right + rounding_));
    }
}

} // namespace edgeshade
