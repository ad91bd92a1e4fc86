#pragma once

#include "src/shadow/scissors/light_space.hpp"

#include <vector>

namespace edgeshade {

/// How near casters are to a light, by the rays that meet them: a grid over all of their extents in
/// a face.
class CasterGrid {
  public:
    /// One of them isn't empty.
    explicit CasterGrid(const std::vector<FaceExtent>& casters);

    /// Whether some of the block's points may be behind a caster; false is certain.
    bool mayBeBehind(const FaceExtent& block) const;

  private:
    struct Cells {
        glm::ivec2 first{0}, last{0};
        int count() const { return (last.x - first.x + 1) * (last.y - first.y + 1); }
    };
    /// Those that an extent meets.
    Cells cellsOf(const glm::vec2& low, const glm::vec2& high) const;
    std::size_t indexOf(int x, int y) const { return static_cast<std::size_t>(y * size_ + x); }

    FaceExtent whole_;
    int size_ = 1;               ///< cells along a side
    glm::vec2 perCell_{0.0f};    ///< cells for a unit
    std::vector<float> nearest_; ///< the least depth, by cell
};

} // namespace edgeshade
