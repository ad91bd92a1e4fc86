#include "src/render/volume_plan.hpp"

#include "src/render/light_reach.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade {
namespace {

constexpr double rounding = 4e-6; // of the coordinates: GL places things in floats

/// Corners of the picture at a depth, in the batch.
std::array<glm::dvec3, 4> rectangleAt(double depth, const FrameView& view,
                                      const glm::dmat4& batchFromView) {
    const double tangent = std::tan(glm::radians(view.camera.fovDegrees) / 2.0);
    const double up = depth * tangent;
    const double right = up * view.width / view.height;
    std::array<glm::dvec3, 4> corners;
    const std::array<glm::dvec2, 4> signs = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
    for (std::size_t i = 0; i < 4; ++i)
        corners[i] = glm::dvec3(batchFromView *
                                glm::dvec4(signs[i].x * right, signs[i].y * up, -depth, 1.0));
    return corners;
}

/// The largest of dot(plane, (p, w)) over a box.
double largestOver(const Box& box, const glm::dvec4& plane, double w = 1.0) {
    const glm::dvec3 normal(plane);
    const glm::dvec3 center = box.center();
    return glm::dot(normal, center) + glm::dot(glm::abs(normal), box.high - center) + plane.w * w;
}

double roundingOf(const Box& box, const glm::dvec4& plane) {
    const glm::dvec3 farthest = glm::max(glm::abs(box.low), glm::abs(box.high));
    return rounding * (glm::dot(glm::abs(glm::dvec3(plane)), farthest) + std::abs(plane.w));
}

/// Whether the whole box is outside the plane.
bool isOutside(const Box& box, const glm::dvec4& plane) {
    return largestOver(box, plane) < -roundingOf(box, plane);
}

/// Whether the box and all that is behind it in the light are outside the plane: extruding leads
/// farther out.
bool isVolumeOutside(const Box& box, const glm::dvec4& plane, const glm::dvec4& light) {
    if (!isOutside(box, plane)) return false;
    const double ofLight = glm::dot(plane, light);
    const double outwards =
        light.w != 0.0 ? largestOver(box, plane) - ofLight : -ofLight; // of p - light, or -light
    return outwards <= -rounding * (std::abs(ofLight) + roundingOf(box, plane)) ||
           (light.w != 0.0 && ofLight >= 0.0);
}

bool mayOverlap(const Box& box, const Box& other) {
    const double margin = rounding * std::max({glm::length(box.low), glm::length(box.high),
                                               glm::length(other.low), glm::length(other.high)});
    for (glm::length_t axis = 0; axis < 3; ++axis)
        if (box.high[axis] + margin < other.low[axis] || other.high[axis] + margin < box.low[axis])
            return false;
    return true;
}

Box boxAround(const glm::dvec3& point) {
    Box box;
    box.add(point);
    return box;
}

/// Whether both winding numbers are certainly 0.
bool areOutside(const ShadowCluster& cluster, const PlanView& view) {
    if (mayOverlap(cluster.bounds, boxAround(view.eye))) return false;
    return view.light.w == 0.0 ||
           !mayOverlap(cluster.bounds, boxAround(glm::dvec3(view.light) / view.light.w));
}

/// Whether a triangle of the cluster may be within the pyramid.
bool mayMeet(const LightPyramid& pyramid, const ShadowCluster& cluster,
             const AdaptedShadow& shadow) {
    if (areApart(pyramid, cluster.bounds)) return false;
    for (std::uint32_t p = 0; p < cluster.parts.count; ++p) {
        if (areApart(pyramid, shadow.parts[cluster.parts.first + p])) continue;
        const std::uint32_t first = cluster.caps.first + p * partTriangles;
        const std::uint32_t end = std::min(first + partTriangles, cluster.caps.end());
        for (std::uint32_t i = first; i < end; ++i) {
            const CapRecord& cap = shadow.caps[i];
            if (!areApart(pyramid, {glm::dvec3(cap.a), glm::dvec3(cap.b), glm::dvec3(cap.c)}))
                return true;
        }
    }
    return false;
}

bool mayCountHalf(const ShadowCluster& cluster, const AdaptedShadow& shadow, const PlanView& view) {
    return cluster.closed && !mayMeet(view.beforeNearest, cluster, shadow) &&
           (areOutside(cluster, view) || !mayMeet(view.fromNearest, cluster, shadow));
}

} // namespace

PlanView planView(const FrameView& view, const DepthSlice& slice, const Light& light,
                  const glm::dmat4& worldFromBatch) {
    const glm::dmat4 viewFromBatch = viewFromWorld(view.camera) * worldFromBatch;
    const glm::dmat4 batchFromView = glm::inverse(viewFromBatch);
    PlanView result;
    result.light = glm::inverse(worldFromBatch) * light.position;
    if (light.hasRange()) result.range = rangeInObject(light.range, worldFromBatch);
    result.eye = glm::dvec3(batchFromView[3]);
    result.nearest = rectangleAt(view.near(), view, batchFromView);
    result.fromNear = {rectangleAt(slice.near, view, batchFromView), result.light};
    result.fromNearest = {result.nearest, result.light};
    result.beforeNearest = {result.nearest, glm::dvec4(result.eye, 1.0)};
    const double aspect = static_cast<double>(view.width) / view.height;
    const glm::dmat4 rows =
        glm::transpose(clipFromView(view.camera, aspect, slice.near) * viewFromBatch);
    const double farthest = std::min(slice.far, view.farthestDepth) * (1.0 + 1e-3);
    glm::dvec4 farthestPlane = -rows[3]; // depth is w
    farthestPlane.w += farthest;
    result.planes = {rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1],
                     rows[3] - rows[1], rows[3] + rows[2], farthestPlane};
    return result;
}

std::vector<VolumeDraw> planVolumes(const AdaptedShadow& shadow, const PlanView& view) {
    const std::vector<ShadowCluster>& clusters = shadow.clusters;
    std::vector<VolumeDraw> draws;
    for (std::uint32_t i = 0; i < clusters.size(); ++i) {
        const ShadowCluster& cluster = clusters[i];
        const bool missed =
            std::any_of(view.planes.begin(), view.planes.end(), [&](const glm::dvec4& plane) {
                return isVolumeOutside(cluster.bounds, plane, view.light);
            });
        if (missed || isBeyond(cluster.bounds, glm::dvec3(view.light), view.range)) continue;
        VolumeDraw draw{{i, 1}, Counted::all, true, true, true};
        draw.zFail = cluster.holes || mayMeet(view.fromNear, cluster, shadow);
        if (mayCountHalf(cluster, shadow, view)) draw.counted = Counted::lightFacing;
        const bool inView =
            std::none_of(view.planes.begin(), view.planes.begin() + 5,
                         [&](const glm::dvec4& p) { return isOutside(cluster.bounds, p); });
        draw.frontCaps = draw.zFail && inView;
        const glm::dvec4 beforeNear = -view.planes[4]; // >= 0 before the near plane
        draw.nearDiscard = draw.frontCaps && !isOutside(cluster.bounds, beforeNear);
        const bool joins =
            !draws.empty() && draws.back().clusters.end() == i && draws.back().drawnLike(draw);
        if (joins)
            ++draws.back().clusters.count;
        else
            draws.push_back(draw);
    }
    return draws;
}

} // namespace edgeshade
