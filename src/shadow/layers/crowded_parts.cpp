#include "src/shadow/layers/crowded_parts.hpp"

#include <algorithm>

namespace edgeshade {

void CrowdedParts::begin(int side) {
    side_ = side;
    cells_.clear();
    segments_.begin();
    uncertain_.begin();
}

void CrowdedParts::place() {
    const auto side = static_cast<std::size_t>(side_);
    at_.assign(side * side, -1);
    before_.assign((side + 1) * (side + 1), 0);
    inSquare_.assign(side * side + 1, 0);
    inSquare_.back() = 1;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        const auto [row, column] = cells_[i];
        at_[static_cast<std::size_t>(row * side_ + column)] = static_cast<int>(i);
        for (int r = std::max(row - 1, 0); r <= row; ++r)
            for (int c = std::max(column - 1, 0); c <= column; ++c)
                inSquare_[static_cast<std::size_t>(r * side_ + c)] = 1;
    }
    for (int row = 0; row < side_; ++row)
        for (int column = 0; column < side_; ++column)
            before_[corner(row + 1, column + 1)] =
                before_[corner(row, column + 1)] + before_[corner(row + 1, column)] -
                before_[corner(row, column)] +
                (at_[static_cast<std::size_t>(row * side_ + column)] >= 0 ? 1 : 0);
}

void CrowdedParts::sort() {
    segments_.sort(cells_.size());
    uncertain_.sort(cells_.size());
}

} // namespace edgeshade
