#pragma once

#include "src/shadow/layers/rays_of_batch.hpp"
#include "src/shadow/silhouette/lanes.hpp"

#include <array>

namespace edgeshade {

/// The map from a batch's space to a directional light's rays, in floats.
class SunRays {
  public:
    /// `rays`: in the face's frame. `box`: around all points.
    SunRays(const RaysOfBatch& rays, const Box& box);

    /// The rays to both ends of an edge, as x, y, x, y. Always the same floats for the same point.
    silhouette::Floats to(const glm::vec3& a, const glm::vec3& b) const {
        const silhouette::Floats x{a.x, a.x, b.x, b.x}, y{a.y, a.y, b.y, b.y},
            z{a.z, a.z, b.z, b.z};
        return columns_[0] * (x - center_.x) + columns_[1] * (y - center_.y) +
               columns_[2] * (z - center_.z) + offset_;
    }
    /// The largest difference of a component from that of RaysOfBatch; not finite if floats can't
    /// hold the map.
    double rounding() const { return rounding_; }

  private:
    glm::vec3 center_; ///< of the box, so that far-off coordinates cancel without rounding
    std::array<silhouette::Floats, 3> columns_;
    silhouette::Floats offset_;
    double rounding_;
};

} // namespace edgeshade
