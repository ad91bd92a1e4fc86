#pragma once

#include "src/shadow/layers/face_chain.hpp"
#include "src/shadow/layers/winding_grid.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace edgeshade {

/// The crowded cells of a WindingGrid: those that may count more than the limit, and all that may
/// touch each. Call begin(), add() for the cells, place(), put() for what touches them, then
/// sort(). It keeps its memory for the next grid.
class CrowdedParts {
  public:
    struct Cell {
        int row, column;
    };

    /// `side`: WindingGrid::side().
    void begin(int side);
    void add(int row, int column) { cells_.push_back({row, column}); }
    void place();
    const std::vector<Cell>& cells() const { return cells_; }

    bool anyAmong(const WindingGrid::Cells& cells) const {
        return before_[corner(cells.top + 1, cells.right + 1)] -
                   before_[corner(cells.bottom, cells.right + 1)] -
                   before_[corner(cells.top + 1, cells.left)] +
                   before_[corner(cells.bottom, cells.left)] >
               0;
    }
    /// Whether any are in a square as of WindingGrid::add(). Elsewhere some may be.
    bool anyInSquare(int cell) const { return inSquare_[static_cast<std::size_t>(cell)] != 0; }

    /// Puts what touches the cell with an index, row * side + column, if it is crowded.
    void put(int index, const FaceSegment& segment) {
        const int cell = at_[static_cast<std::size_t>(index)];
        if (cell >= 0) segments_.put(static_cast<std::uint32_t>(cell), segment);
    }
    void put(int index, const FacePolygon& polygon) {
        const int cell = at_[static_cast<std::size_t>(index)];
        if (cell >= 0) uncertain_.put(static_cast<std::uint32_t>(cell), polygon);
    }
    /// The same for the cells among [left, right] of a row.
    template <class Item>
    void put(int row, int left, int right, const Item& item) {
        for (int column = left; column <= right; ++column)
            put(row * side_ + column, item);
    }
    void sort();

    /// All that was put into a cell, by its place in cells().
    std::span<const FaceSegment> segmentsOf(std::size_t cell) const { return segments_.of(cell); }
    std::span<const FacePolygon> uncertainOf(std::size_t cell) const { return uncertain_.of(cell); }

  private:
    /// Items by cell.
    template <class Item>
    class ByCell {
      public:
        void begin() {
            cellOf_.clear();
            put_.clear();
        }
        void put(std::uint32_t cell, const Item& item) {
            cellOf_.push_back(cell);
            put_.push_back(item);
        }
        /// Sorts by cell, and keeps the order of a cell's items.
        void sort(std::size_t cells) {
            end_.assign(cells + 1, 0);
            for (const std::uint32_t cell : cellOf_)
                ++end_[cell + 1];
            for (std::size_t cell = 0; cell < cells; ++cell)
                end_[cell + 1] += end_[cell];
            // Until the end each cell's items end where the next one's start.
            sorted_.resize(put_.size());
            for (std::size_t i = 0; i < put_.size(); ++i)
                sorted_[end_[cellOf_[i]]++] = put_[i];
        }
        std::span<const Item> of(std::size_t cell) const {
            const std::size_t first = cell == 0 ? 0 : end_[cell - 1];
            return std::span(sorted_).subspan(first, end_[cell] - first);
        }

      private:
        std::vector<std::uint32_t> cellOf_; ///< by item that was put
        std::vector<Item> put_, sorted_;
        std::vector<std::size_t> end_; ///< by cell, in sorted_
    };

    std::size_t corner(int row, int column) const {
        return static_cast<std::size_t>(row * (side_ + 1) + column);
    }

    std::vector<Cell> cells_;
    int side_ = 0;
    std::vector<int> at_;     ///< by cell of the grid: index in cells_; -1: not crowded
    std::vector<int> before_; ///< by corner: number of crowded cells below and left of it
    std::vector<std::uint8_t> inSquare_; ///< by cell: whether the square from it has crowded cells
    ByCell<FaceSegment> segments_;
    ByCell<FacePolygon> uncertain_;
};

} // namespace edgeshade
