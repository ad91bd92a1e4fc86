#pragma once

#include "src/shadow/lights/light_in_batch.hpp"
#include "src/shadow/silhouette/light_facings.hpp"

namespace edgeshade {

/// How far a plane is off its triangle.
struct PlaneError {
    double slope = 0.0;  ///< the difference of the unit normals of plane and triangle
    double offset = 0.0; ///< the distance of the triangle from the plane
};

/// Keeps what CasterFacings finds for a light on its way through a batch's space.
struct FollowedCasters {
    FollowedFacings facings;                ///< of the triangles
    std::vector<std::int8_t> loosePlanes{}; ///< facings of planes that are off their triangles
};

/// Classifies a batch's triangles by the side from which a light sees them, where that is certain
/// for the triangle itself and not only for its plane of floats (docs/method.md, C48).
class CasterFacings {
  public:
    /// Measures how far the planes are off their triangles. Linear in the caps. `shadow` must
    /// outlive this.
    explicit CasterFacings(const PlanePairShadow& shadow);

    /// Sets `followed.facings.facings`, one per cap, for the next place of a light on its way: 1 if
    /// the light is certainly before the triangle, -1 if it is certainly behind; otherwise 0. Caps
    /// whose planes are equal bit for bit get the same number, and those of opposite planes
    /// opposite ones. `followed`: new, or of the last look.
    void follow(const LightInBatch& light, FollowedCasters& followed) const;

    /// The largest magnitude of a coordinate.
    double size() const { return size_; }

  private:
    /// A cap whose plane is off by more than rounding to floats: its triangle is thin, or only
    /// nearly flat with its neighbours.
    struct LooseCap {
        std::uint32_t cap;
        PlaneError error; ///< the largest of all triangles with that plane
    };

    const PlanePairShadow* shadow_;
    LightFacings facings_;
    double size_ = 0.0;
    std::vector<LooseCap> loose_;
};

} // namespace edgeshade
