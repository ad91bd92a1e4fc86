#pragma once

#include "src/shadow/layers/crowded_cells.hpp"

#include <set>

namespace edgeshade {

/// Examines crowded cells one by one: divides them into finer grids while that may separate their
/// members, and finally tests which triangles touch them.
class CloserLook {
  public:
    CloserLook(const FlatCasters& casters, std::size_t limit) : casters_(casters), limit_(limit) {}

    /// Examines a cell of a face (a matrix of LightView::faces) after `depth` halvings of its side.
    /// `mostWork`: pairs of a triangle and a cell from which on it stops dividing.
    void at(const glm::dmat3& face, const CrowdedCell& cell, int depth, std::size_t mostWork);

    /// The most triangles that touch a cell.
    std::size_t most() const { return most_; }
    /// The triangles of each cell touched by more than `limit`; a set, as many neighbours have the
    /// same.
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
