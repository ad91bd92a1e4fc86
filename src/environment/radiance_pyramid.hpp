#pragma once

#include "src/environment/octahedral_map.hpp"

#include <vector>

namespace edgeshade {

/// A map and its successive halves, whose texels are means of four by their solid angles. A lookup
/// gives the average over a wide solid angle.
class RadiancePyramid {
  public:
    /// Builds it from a map whose size is a power of two.
    explicit RadiancePyramid(OctahedralMap map);

    /// Approximate mean over `solidAngle` sr around a direction.
    glm::vec3 lookUp(const glm::vec3& direction, float solidAngle) const;

  private:
    std::vector<OctahedralMap> levels_; ///< from the largest to 1 x 1
    float texelsPerSr_;                 ///< of the largest level, on average
};

} // namespace edgeshade
