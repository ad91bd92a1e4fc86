#include "src/shadow/irregular/sight_lines.hpp"

#include <cmath>

namespace edgeshade {
namespace {

/// The triangle's point that is nearest, or nearly so, to a point of its plane.
glm::dvec3 within(const std::array<glm::dvec3, 3>& corners, const glm::dvec3& normal,
                  const glm::dvec3& point) {
    std::array<double, 3> shares;
    bool inside = true;
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 &a = corners[(i + 1) % 3], &b = corners[(i + 2) % 3];
        shares[i] = glm::dot(normal, glm::cross(a - point, b - point));
        inside = inside && shares[i] >= 0.0;
        sum += std::max(shares[i], 0.0);
    }
    if (inside) return point;
    if (!(sum > 0.0) || !std::isfinite(sum)) return (corners[0] + corners[1] + corners[2]) / 3.0;
    glm::dvec3 nearest(0.0);
    for (std::size_t i = 0; i < 3; ++i)
        nearest += std::max(shares[i], 0.0) / sum * corners[i];
    return nearest;
}

} // namespace

SpacePlane SpacePlane::through(const std::array<glm::dvec3, 3>& corners) {
    const auto& [a, b, c] = corners;
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    return {normal, -glm::dot(normal, a)};
}

SightLines::SightLines(const FrameView& view, const LightSpace& space)
    : perspective_(!view.frustum.orthographic), eye_(space.of(view.frustum.position())) {
    const Frustum& frustum = view.frustum;
    const glm::dmat3 axes = space.turn() * glm::dmat3(glm::inverse(frustum.viewFromWorld));
    forward_ = -axes[2];
    const glm::dvec2 pixel = frustum.size() / glm::dvec2(view.width, view.height);
    column_ = pixel.x * axes[0];
    row_ = pixel.y * axes[1];
    const glm::dvec2 first = frustum.low + 0.5 * pixel;
    first_ = first.x * axes[0] + first.y * axes[1];
}

glm::dvec3 SightLines::placeOn(const std::array<glm::dvec3, 3>& corners, const SpacePlane& plane,
                               int x, int y) const {
    const glm::dvec3 aside =
        first_ + static_cast<double>(x) * column_ + static_cast<double>(y) * row_;
    const glm::dvec3 from = perspective_ ? eye_ : eye_ + aside;
    const glm::dvec3 way = perspective_ ? forward_ + aside : forward_;
    const double depth = -plane.heightOf(from) / glm::dot(plane.normal, way);
    return within(corners, plane.normal, from + depth * way);
}

int SightLines::eyeSideOf(const SpacePlane& plane) const {
    const double side = perspective_ ? plane.heightOf(eye_) : -glm::dot(plane.normal, forward_);
    return side > 0.0 ? 1 : side < 0.0 ? -1 : 0;
}

} // namespace edgeshade
