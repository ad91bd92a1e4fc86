#include "src/shadow/scissors/caster_grid.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade {
namespace {

constexpr int largestGrid = 64;
constexpr int mostCells = 64; ///< that are looked at for one block
constexpr float room = 1e-3f; ///< for rounding, in cells

} // namespace

CasterGrid::CasterGrid(const std::vector<FaceExtent>& casters) {
    for (const FaceExtent& caster : casters)
        whole_.add(caster);
    const double wanted = 2.0 * std::sqrt(static_cast<double>(casters.size()));
    size_ = std::clamp(static_cast<int>(wanted), 1, largestGrid);
    perCell_ = static_cast<float>(size_) / (whole_.high - whole_.low);
    nearest_.assign(indexOf(0, size_), std::numeric_limits<float>::infinity());
    for (const FaceExtent& caster : casters) {
        const Cells cells = cellsOf(caster.low, caster.high);
        for (int y = cells.first.y; y <= cells.last.y; ++y)
            for (int x = cells.first.x; x <= cells.last.x; ++x) {
                float& nearest = nearest_[indexOf(x, y)];
                nearest = std::min(nearest, caster.nearest);
            }
    }
}

CasterGrid::Cells CasterGrid::cellsOf(const glm::vec2& low, const glm::vec2& high) const {
    Cells cells;
    for (glm::length_t i = 0; i < 2; ++i) {
        const auto last = static_cast<float>(size_ - 1);
        // Extents that floats can't divide: all cells.
        if (!(perCell_[i] > 0.0f) || !std::isfinite(perCell_[i])) {
            cells.last[i] = size_ - 1;
            continue;
        }
        const float first = (low[i] - whole_.low[i]) * perCell_[i] - room;
        const float end = (high[i] - whole_.low[i]) * perCell_[i] + room;
        cells.first[i] = static_cast<int>(std::clamp(first, 0.0f, last));
        cells.last[i] = static_cast<int>(std::clamp(end, 0.0f, last));
    }
    return cells;
}

bool CasterGrid::mayBeBehind(const FaceExtent& block) const {
    if (!block.mayBeBehind(whole_)) return false;
    const Cells cells = cellsOf(block.low, block.high);
    if (cells.count() > mostCells) return true;
    for (int y = cells.first.y; y <= cells.last.y; ++y)
        for (int x = cells.first.x; x <= cells.last.x; ++x)
            if (nearest_[indexOf(x, y)] <= block.farthest) return true;
    return false;
}

} // namespace edgeshade
