#pragma once

#include "src/shadow/lights/light.hpp"

#include <limits>

namespace edgeshade {

/// A box in a LightSpace; empty until something is added.
struct LightBox {
    glm::vec3 low{std::numeric_limits<float>::infinity()};
    glm::vec3 high{-std::numeric_limits<float>::infinity()};

    bool empty() const { return low.x > high.x; }
    /// The box enlarged by `by` on all sides.
    LightBox grown(float by) const { return {low - by, high + by}; }
};

/// Range of rays on a LightSpace's face that meet something, and of the depths at which they do;
/// empty if none does.
struct FaceExtent {
    glm::vec2 low{std::numeric_limits<float>::infinity()};
    glm::vec2 high{-std::numeric_limits<float>::infinity()};
    float nearest = std::numeric_limits<float>::infinity();
    float farthest = -std::numeric_limits<float>::infinity();

    bool empty() const { return low.x > high.x; }
};

/// Positions in a light's coordinates. For a directional light x and y are across it and z grows
/// away from it; its single face has all rays (x, y) and depths z. Around a point light the axes
/// are the world's, and the six faces are a cube's. Each has the rays (x / w, y / w) within -1 and
/// 1, where w, the depth, is the coordinate along the face's own axis, and x and y those along the
/// next two.
class LightSpace {
  public:
    /// `near`: a position in the world around which a directional light's coordinates are small.
    LightSpace(const Light& light, const glm::dvec3& near);

    bool directional() const { return directional_; }
    std::size_t faceCount() const { return directional_ ? 1 : 6; }
    /// Transforms of directions of the world, and of a position in it.
    const glm::dmat3& turn() const { return turn_; }
    glm::dvec3 of(const glm::dvec3& place) const { return turn_ * (place - origin_); }
    /// Transform of a batch's positions, precise even far from the world's origin.
    glm::dmat4 fromBatch(const glm::dmat4& worldFromBatch) const;
    /// Conservative bounds of the part of the box on a face.
    FaceExtent extentIn(std::size_t face, const LightBox& box) const;

  private:
    bool directional_;
    glm::dmat3 turn_{1.0};
    glm::dvec3 origin_;
};

} // namespace edgeshade
