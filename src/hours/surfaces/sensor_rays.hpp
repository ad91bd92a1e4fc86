#pragma once

#include "src/hours/surfaces/sensor_light.hpp"
#include "src/rays/lit_rays.hpp"

namespace edgeshade::hours {

/// Light at sensors by certified rays (src/rays/). Sensors light up from the side of their normals
/// alone, on surfaces that cast nothing too.
class SensorRays {
  public:
    /// The scene must outlive it. `castMasked`, `cutoutsCast`: as for rays::surfaceTriangles();
    /// `isHole`: null: casters have no holes.
    SensorRays(const Scene& scene, bool castMasked, bool cutoutsCast, rays::IsHole isHole);

    rays::LitBits lit(std::span<const Sensor> sensors,
                      std::span<const glm::dvec3> directions) const;

    const rays::LitRays& rays() const { return rays_; }
    /// The place that the rays' triangles are relative to.
    const glm::dvec3& origin() const { return origin_; }

  private:
    std::uint32_t numberOf(const Sensor& sensor) const;

    glm::dvec3 origin_;
    rays::LitRays rays_;
    std::vector<std::vector<std::uint32_t>> numbers_; ///< in rays_, by batch and triangle
};

} // namespace edgeshade::hours
