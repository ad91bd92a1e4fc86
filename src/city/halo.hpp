#pragma once

#include "preprocess/base/box.hpp"
#include "src/city/cell_grid.hpp"
#include "src/hours/positions.hpp"

#include <span>

namespace edgeshade::city {

/// Points of a target: the middles of its cells, at a height or above it.
struct TargetBox {
    double west = 0.0, south = 0.0, east = 0.0, north = 0.0; ///< metres, on the lattice
    double lowest = 0.0;                                     ///< metres

    TargetBox(const CellRange& cells, double width, double lowestHeight)
        : west(middleOf(cells.left, width)), south(middleOf(cells.bottom, width)),
          east(middleOf(cells.right - 1, width)), north(middleOf(cells.top - 1, width)),
          lowest(lowestHeight) {}

    /// Horizontal distance of a box; 0 where some point of it may be over a middle.
    double distanceTo(const Box& box) const;
};

/// The least rise of the sun's rays per metre over the ground, a hair too small; 1 without any
/// position.
double leastSlopeOf(std::span<const hours::Position> positions);

/// Whether a caster in this box may shade a point of the target (docs/method.md, C64). `slope`: of
/// leastSlopeOf().
bool mayShade(const Box& caster, const TargetBox& target, double slope);

} // namespace edgeshade::city
