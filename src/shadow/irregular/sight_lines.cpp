#include "src/shadow/irregular/sight_lines.hpp"

#include <algorithm>

namespace edgeshade {

SightLines::SightLines(const FrameView& view, const DepthSlice& slice, const LightSpace& space)
    : perspective_(!view.frustum.orthographic), eye_(space.of(view.frustum.position())) {
    const Frustum& frustum = view.frustum;
    const glm::dmat3 axes = space.turn() * glm::dmat3(glm::inverse(frustum.viewFromWorld));
    forward_ = -axes[2];
    const glm::dvec2 pixel = frustum.size() / glm::dvec2(view.width, view.height);
    column_ = pixel.x * axes[0];
    row_ = pixel.y * axes[1];
    const glm::dvec2 first = frustum.low + 0.5 * pixel;
    first_ = first.x * axes[0] + first.y * axes[1];
    // Perspective: left = K / depth. Orthographic: both are linear.
    const glm::dmat4 clip = view.clipFromView(slice);
    perLeft_ = perspective_ ? -0.5 * clip[3][2] : 2.0 / clip[2][2];
    places_ = view.bounds.empty()
                  ? 0.0
                  : glm::length(glm::max(glm::abs(view.bounds.low - frustum.position()),
                                         glm::abs(view.bounds.high - frustum.position())));
    placing_ = 0x1p-23 / std::min(pixel.x, pixel.y);
    ofNone_ = perspective_ ? 0.0 : (clip[3][2] - 1.0) / clip[2][2];
}

SeenPlane SightLines::seen(const SpacePlane& plane) const {
    const double eye = plane.heightOf(eye_), along = glm::dot(plane.normal, forward_);
    const double first = glm::dot(plane.normal, first_), column = glm::dot(plane.normal, column_),
                 row = glm::dot(plane.normal, row_);
    // Perspective: eye + depth (along + aside) = 0. Orthographic: eye + aside + depth along = 0.
    if (perspective_) {
        const double scale = -perLeft_ / eye;
        return {scale * (along + first), scale * column, scale * row};
    }
    const double scale = -1.0 / (along * perLeft_);
    return {scale * (eye + first) - ofNone_ / perLeft_, scale * column, scale * row};
}

bool SightLines::meets(int x, int y, const std::array<glm::dvec3, 3>& corners,
                       double pixels) const {
    const glm::dvec3 aside = acrossAt(x, y);
    bool left = true, right = true;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 &a = corners[i], &b = corners[(i + 1) % 3];
        // Above 0 on one side of the edge, and linear in the pixel.
        const glm::dvec3 across =
            perspective_ ? glm::cross(a - eye_, b - eye_) : glm::cross(forward_, b - a);
        const double at =
            perspective_ ? glm::dot(across, forward_ + aside) : glm::dot(across, eye_ + aside - a);
        const double room =
            pixels * (std::abs(glm::dot(across, column_)) + std::abs(glm::dot(across, row_)));
        left = left && at >= -room;
        right = right && at <= room;
    }
    return left || right;
}

} // namespace edgeshade
