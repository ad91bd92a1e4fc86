#pragma once

#include "src/shadow/lights/light.hpp"

#include <limits>

namespace edgeshade {

/// A box in a LightSpace; empty until something is added.
struct LightBox {
    glm::vec3 low{std::numeric_limits<float>::infinity()};
    glm::vec3 high{-std::numeric_limits<float>::infinity()};

    bool empty() const { return low.x > high.x; }
    /// Wider by so much on all sides.
    LightBox grown(float by) const { return {low - by, high + by}; }
};

/// The rays of a light that meet something, in one of a LightSpace's faces, and the depths at which
/// they do; empty: none does.
struct FaceExtent {
    glm::vec2 low{std::numeric_limits<float>::infinity()};
    glm::vec2 high{-std::numeric_limits<float>::infinity()};
    float nearest = std::numeric_limits<float>::infinity();
    float farthest = -std::numeric_limits<float>::infinity();

    bool empty() const { return low.x > high.x; }
};

/// Places as a light sees them. Of a directional light x and y are across it and z grows away from
/// it, and its one face has all rays (x, y) and depths z. Around a point light the axes are the
/// world's, and its six faces are a cube's: each has the rays (x / w, y / w) within -1 and 1, where
/// w, the depth, is what a place is along the face's own axis, and x and y along the next two.
class LightSpace {
  public:
    /// `near`: a place in the world around which a directional light's coordinates are small.
    LightSpace(const Light& light, const glm::dvec3& near);

    bool directional() const { return directional_; }
    std::size_t faceCount() const { return directional_ ? 1 : 6; }
    /// Of the world's directions, and of a place in it.
    const glm::dmat3& turn() const { return turn_; }
    glm::dvec3 of(const glm::dvec3& place) const { return turn_ * (place - origin_); }
    /// Of a batch's positions: what is far from the world's origin loses nothing by it.
    glm::dmat4 fromBatch(const glm::dmat4& worldFromBatch) const;
    /// Of what lies in the box. Nothing of it is left out.
    FaceExtent extentIn(std::size_t face, const LightBox& box) const;

  private:
    bool directional_;
    glm::dmat3 turn_{1.0};
    glm::dvec3 origin_;
};

} // namespace edgeshade
