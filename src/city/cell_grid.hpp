#pragma once

#include "src/city/lattice.hpp"

namespace edgeshade::city {

/// Cells of a grid on the world's own axes: cell (i, j) reaches from (i, j) to (i + 1, j + 1) times
/// the width.
struct CellRange {
    std::int64_t left = 0, bottom = 0; ///< first column, from the west, and row, from the south
    std::int64_t right = 0, top = 0;   ///< after the last

    std::int64_t columns() const { return right - left; }
    std::int64_t rows() const { return top - bottom; }
    std::size_t count() const { return static_cast<std::size_t>(columns() * rows()); }
    bool operator==(const CellRange&) const = default;
};

/// The middle of a column or a row, rounded to the lattice: a function of the number and the width
/// alone.
inline double middleOf(std::int64_t cell, double width) {
    return onLattice((static_cast<double>(cell) + 0.5) * width);
}

} // namespace edgeshade::city
