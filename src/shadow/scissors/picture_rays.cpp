#include "src/shadow/scissors/picture_rays.hpp"

#include "src/shadow/geometry/box_plane.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade {
namespace {

/// Rounding of a depth on its way through a rasteriser's floats.
constexpr double depthRounding = 0x1p-21;

/// How far, in pixels, sides may pass by: a grid has at least 16 steps in each (OpenGL ES 2.0.25,
/// table 6.18), and both ends of a side are on it.
constexpr float sidesOff = 0.25f;

/// Beyond this floats may overflow.
constexpr double largestPlace = 1e30;

} // namespace

PictureRays::PictureRays(const FrameView& view, const DepthSlice& slice, const LightSpace& space,
                         int bits)
    : perspective_(!view.frustum.orthographic) {
    const Frustum& frustum = view.frustum;
    const glm::dmat3 axes = space.turn() * glm::dmat3(glm::inverse(frustum.viewFromWorld));
    right_ = glm::vec3(axes[0]);
    up_ = glm::vec3(axes[1]);
    forward_ = glm::vec3(-axes[2]);
    const glm::dvec3 eye = space.of(frustum.position());
    eye_ = glm::vec3(eye);
    const glm::dvec2 pixel = frustum.size() / glm::dvec2(view.width, view.height);
    step_ = glm::vec2(pixel);
    first_ = glm::vec2(frustum.low + 0.5 * pixel);
    // Perspective: left = K / depth. Orthographic: both are linear.
    const glm::dmat4 clip = view.clipFromView(slice);
    perLeft_ = static_cast<float>(perspective_ ? -0.5 * clip[3][2] : 2.0 / clip[2][2]);
    ofNone_ = static_cast<float>(perspective_ ? 0.0 : (clip[3][2] - 1.0) / clip[2][2]);
    leftError_ = static_cast<float>(std::ldexp(2.0, -bits) + depthRounding);
    const double window = glm::length(glm::max(glm::abs(frustum.low), glm::abs(frustum.high)));
    const double rayLength = perspective_ ? std::hypot(window, 1.0) : 1.0;
    const double places =
        glm::length(eye) + glm::length(frustum.position()) + (perspective_ ? 0.0 : window);
    rayLength_ = static_cast<float>(rayLength);
    places_ = static_cast<float>(places);
    fit_ = places + std::max(view.farthestDepth, slice.far < largestPlace ? slice.far : 0.0) *
                        rayLength <
           largestPlace;
}

LightBox PictureRays::boxOf(const PixelRectangle& pixels, float leastLeft, float mostLeft) const {
    const glm::vec2 low =
        first_ + step_ * glm::vec2(static_cast<float>(pixels.x), static_cast<float>(pixels.y));
    const glm::vec2 high = low + step_ * glm::vec2(static_cast<float>(pixels.width - 1),
                                                   static_cast<float>(pixels.height - 1));
    const glm::vec3 left = low.x * right_, right = high.x * right_;
    const glm::vec3 below = low.y * up_, above = high.y * up_;
    glm::vec3 least = glm::min(left, right) + glm::min(below, above);
    glm::vec3 most = glm::max(left, right) + glm::max(below, above);
    const float nearest = std::min(depthOf(leastLeft), depthOf(mostLeft));
    const float farthest = std::max(depthOf(leastLeft), depthOf(mostLeft));
    if (perspective_) {
        least += forward_;
        most += forward_;
        return {eye_ + glm::min(nearest * least, farthest * least),
                eye_ + glm::max(nearest * most, farthest * most)};
    }
    return {eye_ + least + glm::min(nearest * forward_, farthest * forward_),
            eye_ + most + glm::max(nearest * forward_, farthest * forward_)};
}

float PictureRays::errorAt(float leastLeft) const {
    const float depth = depthOf(leastLeft);
    float deeper = std::abs(perLeft_) * leftError_;
    if (perspective_)
        deeper = leastLeft > leftError_ ? depthOf(leastLeft - leftError_) - depth
                                        : std::numeric_limits<float>::infinity();
    const float aside =
        sidesOff * std::max(step_.x, step_.y) * (perspective_ ? depth * rayLength_ : 1.0f);
    return deeper * rayLength_ + aside +
           static_cast<float>(placingError) * (places_ + depth * rayLength_);
}

} // namespace edgeshade
