#pragma once

#include "src/city/city_tile.hpp"
#include "src/city/halo.hpp"
#include "src/city/part_tree.hpp"

#include <span>
#include <vector>

namespace edgeshade::city {

/// Finds the triangles that may shade a target whose surface is known. The target is divided into
/// squares, each with a lowest point of its own (docs/method.md, C64).
class CasterFilter {
  public:
    /// `heights`: of the target's surface at the middles of cells, row by row from the south,
    /// rounded to the lattice; infinite where there is none.
    CasterFilter(const SunFan& fan, const CellRange& cells, double width,
                 std::span<const double> heights);

    /// Calls use(triangle) for each triangle that may shade some point of the target.
    template <class Use>
    void forEach(std::span<const CityTriangle> triangles, const Use& use) const {
        const PartSquares squares(triangles);
        const std::vector<double> leastHeights = leastHeightsOf(triangles, squares);
        for (const CityTriangle& triangle : triangles) {
            const Box box = triangle.box();
            if (box.high.z >= leastHeights[squares.squareOf(box)] && fan_->mayShade(box, target_))
                use(triangle);
        }
    }

  private:
    /// By square, the height below which none of its triangles shades a point of the target.
    std::vector<double> leastHeightsOf(std::span<const CityTriangle> triangles,
                                       const PartSquares& squares) const;

    const SunFan* fan_;
    TargetBox target_;
    std::vector<TargetBox> squares_; ///< of the target, where it has a surface
};

} // namespace edgeshade::city
