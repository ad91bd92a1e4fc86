#include "src/shadow/layers/crowded_cells.hpp"

namespace edgeshade {

CrowdedCells::CrowdedCells(const TouchGrid& grid, std::size_t limit, std::size_t& most) {
    for (int row = 0; row < grid.side(); ++row)
        for (int column = 0; column < grid.side(); ++column) {
            const std::size_t count = grid.count(row, column);
            if (count <= limit) {
                most = std::max(most, count);
                continue;
            }
            if (at_.empty()) at_.assign(static_cast<std::size_t>(grid.side() * grid.side()), -1);
            at_[static_cast<std::size_t>(row * grid.side() + column)] =
                static_cast<std::int32_t>(cells_.size());
            cells_.push_back({grid.cell(row, column)});
            cells_.back().members.reserve(count);
        }
}

CrowdedCells CrowdedCells::ofAll(const Outline& part) {
    CrowdedCells result;
    result.cells_ = {{part}};
    result.at_ = {0};
    return result;
}

void CrowdedCells::add(const CellMember& member, std::span<const glm::dvec2> polygon,
                       const TouchGrid& grid) {
    grid.forEachSpan(polygon, [&](int row, int left, int right) {
        const std::int32_t* at = &at_[static_cast<std::size_t>(row * grid.side())];
        for (int column = left; column <= right; ++column)
            if (at[column] >= 0)
                cells_[static_cast<std::size_t>(at[column])].members.push_back(member);
    });
}

} // namespace edgeshade
