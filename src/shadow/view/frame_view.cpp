#include "src/shadow/view/frame_view.hpp"

#include "src/shadow/geometry/box_plane.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade {
namespace {

constexpr double slicePays = 64.0; // ratio of depths from which another slice is worthwhile
constexpr int mostSlices = 8;

/// Margin before and behind the scene in an orthographic picture, as a share of its size.
constexpr double orthographicMargin = 1e-2;

/// The depths of the whole scene, with a margin.
DepthRange wholeDepth(const Frustum& frustum, const Box& bounds) {
    if (bounds.empty()) return {1.0, 2.0};
    const Interval depths = depthsOf(frustum, bounds);
    const double margin = orthographicMargin * std::max(bounds.diagonal(), 1e-9);
    return {depths.low - margin, depths.high + margin};
}

/// The scene's bounds, extended by its ground.
Box boundsWithGround(const Scene& scene, Box bounds) {
    for (const Batch& batch : scene.batches)
        if (batch.ground)
            for (const glm::vec3& position : batch.geometry->positions)
                bounds.add(glm::dvec3(batch.worldFromBatch * glm::dvec4(position, 1.0)));
    return bounds;
}

/// The plane that cuts casters for a point light, see FrameLight::cut; null if not needed.
std::optional<glm::dvec4> cutAt(const Light& light, const Frustum& frustum, const Box& bounds) {
    if (!frustum.orthographic || light.position.w == 0.0 || bounds.empty()) return std::nullopt;
    const glm::dvec3 forward = frustum.forward();
    const glm::dvec4 plane(forward, -glm::dot(forward, glm::dvec3(light.position)));
    const bool among = largestOver(bounds, plane) > 0.0 && largestOver(bounds, -plane) > 0.0;
    return among ? std::optional(plane) : std::nullopt;
}

void findNearestDepths(const Scene& scene, const SceneTree& tree, FrameView& view) {
    for (std::size_t i = 0; i < scene.batches.size(); ++i)
        view.nearestDepths.push_back(scene.batches[i].ground && !view.ground
                                         ? DepthRange().nearest
                                         : nearestDepth(scene, tree, i, view.frustum));
}

/// Fills in the requested lights.
void addLights(const FrameRequest& request, FrameView& view) {
    view.lights.resize(request.lights.size());
    for (std::size_t i = 0; i < view.lights.size(); ++i) {
        const Light& light = request.lights[i];
        FrameLight& of = view.lights[i];
        of.clear();
        of.light = light;
        of.cut = cutAt(light, view.frustum, view.bounds);
        if (light.extent && request.lightSamples > 0)
            findLightPoints(light, request.lightSamples, of.points);
    }
}

/// Some of a light's points, as lights.
std::vector<FrameLight> pointsOf(const FrameView& view, std::size_t light, std::size_t first,
                                 std::size_t count) {
    const FrameLight& of = view.lights[light];
    std::vector<FrameLight> points;
    for (std::size_t i = first; i < first + count; ++i) {
        FrameLight& point = points.emplace_back();
        point.light = of.points[i];
        point.layers = of.layers;
        point.drawn = of.drawn;
        point.cut = cutAt(point.light, view.frustum, view.bounds);
        point.atRest = false;
        point.among = AmongPoints{light, regionOf(of.light)};
    }
    return points;
}

} // namespace

double fittedNear(double nearest, double diagonal) {
    const double smallest = diagonal > 0.0 ? 1e-6 * diagonal : 1e-6;
    return std::isfinite(nearest) ? std::max(0.99 * nearest, smallest)
                                  : std::max(0.01 * diagonal, smallest);
}

void divideDepth(double near, double farthest, std::optional<int> count,
                 std::vector<DepthSlice>& result) {
    const double ratio = std::max(1.0, farthest / near);
    const int slices =
        count ? *count
              : std::clamp(static_cast<int>(std::ceil(std::log(ratio) / std::log(slicePays))), 1,
                           mostSlices);
    result.clear();
    for (int i = slices - 1; i >= 0; --i) {
        DepthSlice slice;
        slice.near = near * std::pow(ratio, static_cast<double>(i) / slices);
        if (!result.empty()) slice.far = result.back().near;
        result.push_back(slice);
    }
}

void FrameLight::clear() {
    std::vector<std::uint32_t> groupOf = std::move(layers.groupOf);
    std::vector<Light> kept = std::move(points);
    *this = {};
    layers.groupOf = std::move(groupOf);
    points = std::move(kept);
    layers.groupOf.clear();
    points.clear();
}

void FrameView::clear() {
    std::vector<FrameLight> keptLights = std::move(lights);
    std::vector<DepthSlice> keptSlices = std::move(slices);
    std::vector<double> keptDepths = std::move(nearestDepths);
    *this = {};
    lights = std::move(keptLights);
    slices = std::move(keptSlices);
    nearestDepths = std::move(keptDepths);
    lights.clear();
    slices.clear();
    nearestDepths.clear();
}

void FrameView::divide(std::optional<int> count) {
    if (!frustum.orthographic) divideDepth(near(), farthestDepth, count, slices);
}

FrameView aloneView(const FrameView& view, std::size_t light) {
    FrameView alone = view;
    alone.lights = {view.lights[light]};
    alone.lights[0].number = view.numberOf(light);
    return alone;
}

FrameView pointsView(const FrameView& view, std::size_t light, std::size_t first,
                     std::size_t count) {
    FrameView result = view;
    result.lights = pointsOf(view, light, first, count);
    result.mask = true;
    result.sumsMasks = true;
    return result;
}

FrameView pointsByMapView(const FrameView& view, std::size_t light, std::size_t first,
                          std::size_t count, std::size_t atOnce) {
    const FrameLight& of = view.lights[light];
    FrameView result = view;
    result.lights.clear();
    for (std::size_t i = first; i < first + count; i += atOnce) {
        FrameLight& pass = result.lights.emplace_back();
        pass.light = of.light;
        pass.light.cone = of.points[i].cone;
        pass.drawn = of.drawn;
        pass.atRest = false;
        const auto begin = of.points.begin() + static_cast<std::ptrdiff_t>(i);
        pass.points.assign(
            begin, begin + static_cast<std::ptrdiff_t>(std::min(atOnce, first + count - i)));
        pass.atOnce = true;
    }
    result.mask = true;
    result.sumsMasks = true;
    return result;
}

FrameView shadedByPoints(const FrameView& view) {
    FrameView result = view;
    result.lights.clear();
    for (std::size_t i = 0; i < view.lights.size(); ++i) {
        const FrameLight& light = view.lights[i];
        if (light.points.empty()) {
            result.lights.push_back(light);
            continue;
        }
        for (FrameLight& point : pointsOf(view, i, 0, light.points.size())) {
            point.weight = light.weight / static_cast<double>(light.points.size());
            result.lights.push_back(std::move(point));
        }
    }
    return result;
}

FrameView makeFrameView(const Scene& scene, const FrameRequest& request, const Box& bounds) {
    return makeFrameView(scene, request, bounds, SceneTree(scene));
}

FrameView makeFrameView(const Scene& scene, const FrameRequest& request, const Box& bounds,
                        const SceneTree& tree) {
    FrameView view;
    makeFrameView(scene, request, bounds, tree, view);
    return view;
}

void makeFrameView(const Scene& scene, const FrameRequest& request, const Box& bounds,
                   const SceneTree& tree, FrameView& view) {
    requireFewLights(request.lights.size());
    std::vector<FrameLight> lights = std::move(view.lights);
    view.clear();
    view.lights = std::move(lights);
    const Box all = boundsWithGround(scene, bounds);
    view.frustum = standingBack(request.frustum, all);
    view.width = request.width;
    view.height = request.height;
    view.bounds = bounds;
    view.culls = scene.culls;
    addLights(request, view);
    const auto& ground = tree.ground();
    view.ground = ground && request.ground && isAboveGround(view.frustum, scene.batches[*ground]);
    const VisiblePart seen = visiblePart(scene, tree, view.frustum, view.ground);
    if (request.nearestDepths) findNearestDepths(scene, tree, view);
    view.visible = seen.box;
    view.slopes = seen.slopes;
    view.farthestDepth = seen.depth.farthest;
    if (view.frustum.orthographic) {
        const DepthRange depth = wholeDepth(view.frustum, all);
        view.slices.push_back({.near = depth.nearest});
        view.farPlane = depth.farthest;
        return;
    }
    const double near =
        request.depth.near.value_or(fittedNear(seen.depth.nearest, view.bounds.diagonal()));
    divideDepth(near, seen.depth.farthest, request.depth.slices, view.slices);
}

} // namespace edgeshade
