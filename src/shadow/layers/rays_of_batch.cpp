#include "src/shadow/layers/rays_of_batch.hpp"

#include "preprocess/base/vectors.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade {
namespace {

/// The largest power of two of a frame's scale: its inverse is no denormal.
constexpr int mostScaling = 1000;

} // namespace

FaceFrame FaceFrame::around(const Outline& outline) {
    const double extent = std::max(outline.u1 - outline.u0, outline.v1 - outline.v0);
    if (!std::isfinite(extent)) return {};
    FaceFrame frame{0.5 * glm::dvec2(outline.u0 + outline.u1, outline.v0 + outline.v1), 1.0};
    if (extent > 0.0)
        frame.scale = std::ldexp(1.0, std::clamp(-std::ilogb(extent), -mostScaling, mostScaling));
    return frame;
}

RaysOfBatch::RaysOfBatch(const LightView& view, const glm::dmat4& worldFromBatch, double size)
    : linear(view.axes * glm::dmat3(worldFromBatch)), offset(view.rayTo(worldFromBatch[3])),
      mirrors(glm::determinant(glm::dmat3(worldFromBatch)) < 0.0) {
    double largest = 0.0;
    for (glm::length_t i = 0; i < 3; ++i)
        largest += largestComponent(glm::dvec3(worldFromBatch[i]));
    rounding = 0x1p-48 * (largest * size + largestComponent(glm::dvec3(worldFromBatch[3])) +
                          largestComponent(view.origin));
}

Outline RaysOfBatch::outlineOf(const Box& box) const {
    const glm::dvec3 center = linear * box.center() + offset, half = 0.5 * (box.high - box.low);
    glm::dvec3 extent(0.0);
    for (glm::length_t i = 0; i < 3; ++i)
        extent += glm::abs(linear[i]) * half[i];
    return {center.x - extent.x, center.x + extent.x, center.y - extent.y, center.y + extent.y};
}

void RaysOfBatch::enter(const FaceFrame& frame) {
    linear *= frame.scale;
    offset = glm::dvec3(frame.to(glm::dvec2(offset)), offset.z);
    rounding *= frame.scale;
}

} // namespace edgeshade
