#include "src/shadow/view/batch_in_view.hpp"

#include "src/shadow/geometry/box_plane.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_access.hpp>

namespace edgeshade {
namespace {

constexpr double widening = 1.001; // of the window, against rounding

/// The frustum with its window enlarged by the factor `widening`.
Frustum widened(Frustum frustum) {
    const glm::dvec2 more = 0.5 * (widening - 1.0) * frustum.size();
    frustum.low -= more;
    frustum.high += more;
    return frustum;
}

std::array<Side, 5> sidesOf(const Frustum& frustum) {
    const glm::dvec2 &low = frustum.low, &high = frustum.high;
    const Side front = {{0.0, 0.0, -1.0}, 0.0};
    if (frustum.orthographic)
        return {Side{{1.0, 0.0, 0.0}, -low.x}, Side{{-1.0, 0.0, 0.0}, high.x},
                Side{{0.0, 1.0, 0.0}, -low.y}, Side{{0.0, -1.0, 0.0}, high.y}, front};
    return {Side{{1.0, 0.0, low.x}, 0.0}, Side{{-1.0, 0.0, -high.x}, 0.0},
            Side{{0.0, 1.0, low.y}, 0.0}, Side{{0.0, -1.0, -high.y}, 0.0}, front};
}

bool isInside(const Side& side, const Polygon& polygon) {
    return std::all_of(polygon.corners.begin(), polygon.corners.begin() + polygon.count,
                       [&](const glm::dvec3& corner) {
                           return glm::dot(side.normal, corner) + side.offset >= 0.0;
                       });
}

/// Whether a triangle in the picture's camera space certainly shows its back. `mirrored`: its
/// transform reverses winding; `error`: bound of a GL's error in placing its corners.
bool showsBack(const Polygon& triangle, bool orthographic, bool mirrored, double error) {
    const glm::dvec3 &a = triangle.corners[0], &b = triangle.corners[1], &c = triangle.corners[2];
    const glm::dvec3 ab = b - a, ac = c - a;
    const glm::dvec3 towardsEye = orthographic ? glm::dvec3(0.0, 0.0, 1.0) : -a;
    const double side = (mirrored ? -1.0 : 1.0) * glm::dot(glm::cross(ab, ac), towardsEye);
    const double sides = glm::length(ab) + glm::length(ac) + error;
    return side < -4.0 * error * sides * (sides + glm::length(towardsEye));
}

} // namespace

ClippingFrustum::ClippingFrustum(const Frustum& given)
    : frustum(widened(given)), sides(sidesOf(frustum)),
      worldFromView(glm::inverse(frustum.viewFromWorld)) {}

double placingErrorOf(const glm::dvec3& farthest, const glm::dmat4& viewFromPoints) {
    double largest = 0.0;
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        const glm::dvec4 row = glm::abs(glm::row(viewFromPoints, axis));
        largest = std::max(largest, glm::dot(row, glm::dvec4(farthest, 1.0)));
    }
    return placingError * largest;
}

SlopeErrors slopeErrorsOf(const Frustum& widened, double error) {
    if (widened.orthographic) return {0.0, error};
    // x / d, with errors of e in both, is off by at most e (1 + |x / d|) / (d - e). As d > 2 e,
    // that is at most 2 e (1 + |x / d|) / d.
    const glm::dvec2 widest = glm::max(glm::abs(widened.low), glm::abs(widened.high));
    return {2.0 * error, 2.0 * error * (1.0 + std::max(widest.x, widest.y))};
}

BatchInView::BatchInView(const ClippingFrustum& clipping, const Scene& scene, const Batch& batch,
                         const glm::dvec3& farthest)
    : clipping_(clipping), scene_(scene), geometry_(*batch.geometry),
      viewFromBatch_(clipping.frustum.viewFromWorld * batch.worldFromBatch),
      error_(placingErrorOf(farthest, viewFromBatch_)),
      slopeErrors_(slopeErrorsOf(clipping.frustum, error_)),
      mirrored_(glm::determinant(glm::dmat3(viewFromBatch_)) < 0.0) {}

bool BatchInView::isSingleSided(std::uint32_t index) const {
    const std::vector<SurfaceGroup>& groups = geometry_.groups;
    const auto after = std::upper_bound(
        groups.begin(), groups.end(), index,
        [](std::uint32_t at, const SurfaceGroup& group) { return at < group.firstIndex; });
    if (after == groups.begin()) return false;
    const SurfaceGroup& group = *(after - 1);
    return index - group.firstIndex < group.indexCount &&
           !scene_.materials[group.material].doubleSided;
}

void BatchInView::add(std::uint32_t triangle, VisiblePart& part) const {
    Polygon polygon;
    for (std::size_t c = 0; c < 3; ++c) {
        const glm::vec3& position = geometry_.positions[geometry_.indices[3 * triangle + c]];
        polygon.add(glm::dvec3(viewFromBatch_ * glm::dvec4(position, 1.0)));
    }
    if (scene_.culls && isSingleSided(3 * triangle) &&
        showsBack(polygon, clipping_.frustum.orthographic, mirrored_, error_))
        return;
    for (const Side& side : clipping_.sides)
        if (!isInside(side, polygon)) polygon = clipped(polygon, side.normal, side.offset);
    for (std::size_t c = 0; c < polygon.count; ++c) {
        const glm::dvec3& corner = polygon.corners[c];
        part.depth.add(std::max(0.0, -corner.z));
        part.box.add(glm::dvec3(clipping_.worldFromView * glm::dvec4(corner, 1.0)));
        addSlopes(corner, part.slopes);
    }
}

void BatchInView::addSlopes(const glm::dvec3& point, Slopes& slopes) const {
    const Frustum& frustum = clipping_.frustum;
    const double depth = -point.z, unit = frustum.orthographic ? 1.0 : depth;
    const auto add = [&](Interval& known, double offset, double low, double high) {
        if (!(depth > slopeErrors_.nearest)) return known.add(Interval{low, high});
        for (const double error : {-slopeErrors_.offset, slopeErrors_.offset})
            known.add(std::clamp((offset + error) / unit, low, high));
    };
    add(slopes.right, point.x, frustum.low.x, frustum.high.x);
    add(slopes.up, point.y, frustum.low.y, frustum.high.y);
}

} // namespace edgeshade
