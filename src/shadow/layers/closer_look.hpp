#pragma once

#include "src/shadow/layers/crowded_cells.hpp"

#include <set>

namespace edgeshade {

/// Looks at crowded cells one by one: parts them in finer grids while that may part their members,
/// and asks in the end which triangles touch them.
class CloserLook {
  public:
    CloserLook(const FlatCasters& casters, std::size_t limit) : casters_(casters), limit_(limit) {}

    /// At a cell of a face (a matrix as LightView::faces has them) after so many halvings of its
    /// side. `mostWork`: pairs of a triangle and a cell from which on it gives up parting.
    void at(const glm::dmat3& face, const CrowdedCell& cell, int depth, std::size_t mostWork);

    /// The most that touch a cell.
    std::size_t most() const { return most_; }
    /// Those of each cell that more than `limit` touch; many neighbours have the same.
    const std::set<TriangleIndices>& crowded() const { return crowded_; }

  private:
    void refine(const glm::dmat3& face, const CrowdedCell& cell, int depth);
    bool isCovered(const CrowdedCell& cell) const;
    void findTouching(const glm::dmat3& face, const CrowdedCell& cell);

    const FlatCasters& casters_;
    const std::size_t limit_;
    std::size_t most_ = 0;
    std::size_t work_ = 0, mostWork_ = 0;
    std::set<TriangleIndices> crowded_;
};

} // namespace edgeshade
