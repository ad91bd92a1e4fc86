#pragma once

#include "preprocess/base/box.hpp"
#include "src/city/cell_grid.hpp"
#include "src/hours/positions.hpp"

#include <span>
#include <vector>

namespace edgeshade::city {

/// Points of a target: the middles of its cells, at a height or above it.
struct TargetBox {
    double west = 0.0, south = 0.0, east = 0.0, north = 0.0; ///< metres, on the lattice
    double lowest = 0.0;                                     ///< metres

    TargetBox(const CellRange& cells, double width, double lowestHeight)
        : west(middleOf(cells.left, width)), south(middleOf(cells.bottom, width)),
          east(middleOf(cells.right - 1, width)), north(middleOf(cells.top - 1, width)),
          lowest(lowestHeight) {}

    /// Whether some point of a box may be over or below a middle.
    bool isUnder(const Box& box) const {
        return box.low.x <= east && box.high.x >= west && box.low.y <= north && box.high.y >= south;
    }
};

/// The directions of a plan's sun positions, bundled by azimuth, so that a year's take no more than
/// 180 tests.
class SunFan {
  public:
    explicit SunFan(std::span<const hours::Position> positions);

    /// Whether a caster in this box may shade a point of the target, or is over or below one
    /// (docs/method.md, C64).
    bool mayShade(const Box& caster, const TargetBox& target) const;

    /// The height below which no caster over or under the box shades a point of the target.
    double leastHeight(const Box& caster, const TargetBox& target) const;

  private:
    struct Offsets;
    /// Directions between two azimuths.
    struct Blade {
        glm::dvec2 middle{0.0}; ///< over the ground, of length 1
        double halfAngle = 0.0; ///< radians on each side of the middle
        double slope = 0.0;     ///< least rise per metre over the ground
    };

    std::vector<Blade> blades_;
    double leastSlope_ = 1.0;
};

} // namespace edgeshade::city
