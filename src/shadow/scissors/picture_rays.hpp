#pragma once

#include "src/shadow/geometry/frame_view.hpp"
#include "src/shadow/geometry/pixel_rectangle.hpp"
#include "src/shadow/scissors/light_space.hpp"

namespace edgeshade {

/// The lines of sight of a picture in a light's space, and what its depth buffer says of them.
/// Depths are told by what is *left* of the buffer's range behind a point: 1 - depth, 0 where
/// nothing was drawn.
class PictureRays {
  public:
    /// `bits`: of the slice's depth buffer.
    PictureRays(const FrameView& view, const DepthSlice& slice, const LightSpace& space, int bits);

    /// Whether floats hold all places.
    bool fit() const { return fit_; }
    /// The distance along the viewing direction.
    float depthOf(float left) const {
        return perspective_ ? perLeft_ / left : ofNone_ + perLeft_ * left;
    }
    /// A box around all points of these pixels of which so much is left, at least and at most.
    LightBox boxOf(const PixelRectangle& pixels, float leastLeft, float mostLeft) const;

    /// How far a volume's side may pass by points, of which so much is left at least, that GL
    /// counts as within it: by rounding, and as vertices are put on a rasteriser's grid.
    float errorAt(float leastLeft) const;

  private:
    bool perspective_ = true, fit_ = true;
    glm::vec3 eye_{0.0f}, right_{0.0f}, up_{0.0f}, forward_{0.0f};
    glm::vec2 first_{0.0f}, step_{0.0f}; ///< of the window: the first pixel's, and to the next
    float perLeft_ = 0.0f, ofNone_ = 0.0f, leftError_ = 0.0f;
    float rayLength_ = 1.0f; ///< the longest, a unit of depth
    float places_ = 0.0f;    ///< the sum of what else is rounded
};

} // namespace edgeshade
