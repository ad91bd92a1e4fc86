#pragma once

#include "src/environment/octahedral_map.hpp"

#include <vector>

namespace edgeshade {

/// A map and its halves, each texel the mean of four by their solid angles, so that averages over
/// wide solid angles are one look-up.
class RadiancePyramid {
  public:
    /// Of a map whose size is a power of two.
    explicit RadiancePyramid(OctahedralMap map);

    /// About the mean over so many sr around a direction.
    glm::vec3 lookUp(const glm::vec3& direction, float solidAngle) const;

  private:
    std::vector<OctahedralMap> levels_; ///< from the largest to 1 x 1
    float texelsPerSr_;                 ///< of the largest, on average
};

} // namespace edgeshade
