#pragma once

#include "src/shadow/geometry/frame_view.hpp"
#include "src/shadow/scissors/light_space.hpp"

#include <array>
#include <cmath>

namespace edgeshade {

/// A plane in a LightSpace: dot(normal, p) + offset is 0 on it.
struct SpacePlane {
    glm::dvec3 normal{0.0};
    double offset = 0.0;

    double heightOf(const glm::dvec3& place) const { return glm::dot(normal, place) + offset; }
};

/// A plane as a picture's lines of sight meet it. What is left of the depth range behind it,
/// 1 - depth, is linear in the pixel.
struct SeenPlane {
    double none = 0.0, perColumn = 0.0, perRow = 0.0;

    double leftAt(int x, int y) const { return none + perColumn * x + perRow * y; }
};

/// The lines of sight of a picture's pixels in a light's space, and what its depth buffer says of
/// them. Depths are told by what is left of the buffer's range behind a point: 1 - depth.
class SightLines {
  public:
    SightLines(const FrameView& view, const DepthSlice& slice, const LightSpace& space);

    /// What is seen in a pixel, of which so much is left; not 0.
    glm::dvec3 placeOf(int x, int y, double left) const {
        const double depth = depthOf(left);
        const glm::dvec3 aside = acrossAt(x, y);
        return perspective_ ? eye_ + depth * (forward_ + aside) : eye_ + depth * forward_ + aside;
    }
    /// How far, in pixels, floats may have put vertices aside at a depth.
    double asideAt(double left) const {
        const double depth = depthOf(left);
        return placing_ * (places_ + std::abs(depth)) / (perspective_ ? depth : 1.0);
    }
    /// The sign of heights over a plane where the eye is; 0: it is seen from its edge.
    int eyeSideOf(const SpacePlane& plane) const {
        const double side = perspective_ ? plane.heightOf(eye_) : -glm::dot(plane.normal, forward_);
        return side > 0.0 ? 1 : side < 0.0 ? -1 : 0;
    }
    /// Of one that isn't seen from its edge.
    SeenPlane seen(const SpacePlane& plane) const;
    /// Whether a pixel's line of sight meets a triangle of the plane, or passes it by no more than
    /// so many pixels.
    bool meets(int x, int y, const std::array<glm::dvec3, 3>& corners, double pixels) const;

  private:
    glm::dvec3 acrossAt(int x, int y) const {
        return first_ + static_cast<double>(x) * column_ + static_cast<double>(y) * row_;
    }
    double depthOf(double left) const {
        return perspective_ ? perLeft_ / left : ofNone_ + perLeft_ * left;
    }

    bool perspective_;
    glm::dvec3 eye_, forward_;
    /// Across the line of sight: the first pixel's, and to the next column and row.
    glm::dvec3 first_, column_, row_;
    double perLeft_, ofNone_;
    double places_;  ///< the size of what is rounded
    double placing_; ///< pixels, a unit of depth, for each of it
};

} // namespace edgeshade
