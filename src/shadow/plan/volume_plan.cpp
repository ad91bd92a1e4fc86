#include "src/shadow/plan/volume_plan.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/base/vectors.hpp"
#include "src/shadow/geometry/box_plane.hpp"
#include "src/shadow/geometry/planes_between.hpp"
#include "src/shadow/lights/light_range.hpp"
#include "src/shadow/view/near_rectangle.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade {
namespace {

/// Distance beyond the visible geometry at which volumes end, as a share of its size.
constexpr double endMargin = 2e-3;

/// Least distance of casters below the light, as a share of the light's height above a plane, for
/// their volumes to end at that plane.
constexpr double leastBelow = 1e-2;

/// Whether the box and everything behind it, as seen from the light, are outside the plane: the
/// extrusion leads farther out.
bool isVolumeOutside(const Box& box, const glm::dvec4& plane, const glm::dvec4& light) {
    if (!isOutside(box, plane)) return false;
    const double ofLight = glm::dot(plane, light);
    const double outwards =
        light.w != 0.0 ? largestOver(box, plane) - ofLight : -ofLight; // of p - light, or of -light
    return outwards <= -placingError * (std::abs(ofLight) + roundingOf(box, plane)) ||
           (light.w != 0.0 && ofLight >= 0.0);
}

/// Whether the view may contain directions from the light to points of the box, where back caps
/// lie. A directional light has no back caps: its points at infinity are one point.
bool mayBackCapsBeSeen(const Box& box, const PlanView& view) {
    if (view.light.w == 0.0) return false;
    return std::none_of(view.planes.begin(), view.planes.begin() + 4, [&](const glm::dvec4& plane) {
        const double ofLight = glm::dot(plane, view.light);
        const double margin = roundingOf(box, plane) + placingError * std::abs(ofLight);
        return largestOver(box, plane) - ofLight < -margin;
    });
}

/// Whether the winding numbers at the eye and at the light are both certainly 0.
bool areOutside(const ShadowCluster& cluster, const PlanView& view) {
    return isOutsideOf(cluster.bounds, view.eye) && isOutsideOf(cluster.bounds, view.light);
}

/// The faces of a view's volumes, made when they are needed.
class ViewVolumes {
  public:
    /// `view` must outlive it.
    explicit ViewVolumes(const PlanView& view) : view_(view) {}

    const ClipVolumeFaces& fromNear() { return made(near_, view_.fromNear); }
    const ClipVolumeFaces& fromNearest() { return made(nearest_, view_.fromNearest); }
    const ClipVolumeFaces& beforeNearest() { return made(before_, view_.beforeNearest); }

  private:
    static const ClipVolumeFaces& made(std::optional<ClipVolumeFaces>& faces,
                                       const NearClipVolume& volume) {
        if (!faces) faces.emplace(volume);
        return *faces;
    }

    const PlanView& view_;
    std::optional<ClipVolumeFaces> near_, nearest_, before_;
};

/// Whether the eye may see through culled backs of the cluster: whether any single-sided triangle
/// may face away from the eye, by the shaders' dot product, and be in the picture.
bool mayBeCulled(const ShadowCluster& cluster, const PlanePairShadow& shadow, const PlanView& view,
                 ViewVolumes& volumes, bool solid) {
    if (!view.culls || cluster.singleSided == 0) return false;
    // The eye then meets a front first.
    if (solid && isOutsideOf(cluster.bounds, view.eye) &&
        !anyCapTouches(volumes.beforeNearest(), cluster, shadow))
        return false;
    const auto aside = [&](const glm::dvec4& plane) { return isOutside(cluster.bounds, plane); };
    if (std::any_of(view.planes.begin(), view.planes.begin() + 4, aside)) return false;
    const auto first = shadow.caps.begin() + cluster.caps.first;
    return std::any_of(first, first + cluster.singleSided, [&](const CapRecord& cap) {
        const glm::dvec4 terms = glm::dvec4(cap.plane) * view.eye;
        const glm::dvec4 sizes = glm::abs(terms);
        return terms.x + terms.y + terms.z + terms.w <=
               view.rounding * (sizes.x + sizes.y + sizes.z + sizes.w);
    });
}

/// Decides which of the cluster's triangles count, by its winding numbers at the eye and the light
/// (docs/method.md, C8 and C39). Outside the cluster's bounds they are 0. Elsewhere `touched`, the
/// triangles between near rectangle and light, give their difference. Null if everything visible is
/// in the cluster's shadow.
std::optional<Counted> countedOf(const ShadowCluster& cluster, const PlanePairShadow& shadow,
                                 const PlanView& view, ViewVolumes& volumes, const Touched& touched,
                                 bool culled) {
    if (!cluster.closed || anyCapTouches(volumes.beforeNearest(), cluster, shadow))
        return Counted::all;
    // There is no winding number for a light on the surface itself.
    if (view.contact.anyOf(cluster.caps)) return Counted::all;
    const Counted half = culled ? Counted::facingAway : Counted::lightFacing;
    if (touched.caps.empty() || areOutside(cluster, view)) return half;
    if (touched.tooMany) return Counted::all;
    const auto crossings =
        crossingsFromSomePoint(view.fromNearest, touched.caps, shadow, view.rounding);
    if (!crossings) return Counted::all;
    // For each component, outward crossings less inward ones are its winding number at the eye less
    // that at the light.
    const bool sumTells =
        cluster.components == 1 || crossings->outwards == 0 || crossings->inwards == 0;
    if (!sumTells) return Counted::all;
    if (crossings->outwards == crossings->inwards) return half;
    // Culled backs can only lower the winding number at the eye.
    if (culled && crossings->outwards > crossings->inwards) return Counted::all;
    return std::nullopt;
}

/// Decides whether the cluster needs caps, and if not, the count at which the whole near rectangle
/// starts.
void decideCaps(const ShadowCluster& cluster, const PlanePairShadow& shadow, const PlanView& view,
                ViewVolumes& volumes, Touched& touched, ClusterPlan& draw) {
    draw.caps = CapsNeeded::seenThrough;
    if (cluster.alphaTested) return;
    draw.caps = CapsNeeded::no;
    if (touched.caps.empty()) return;
    draw.caps = CapsNeeded::uncertain;
    if (touched.tooMany || view.contact.reach > 0.0f) return;
    switch (evennessOf(volumes.fromNear(), touched, shadow, view.rounding)) {
    case Evenness::uncertain:
        return;
    case Evenness::rectangleMet:
        draw.caps = CapsNeeded::nearPlaneMet;
        return;
    case Evenness::outlineMet:
        draw.caps = CapsNeeded::outlineMet;
        return;
    case Evenness::even:
        break;
    }
    const auto crossings =
        crossingsFromSomePoint(view.fromNear, touched.caps, shadow, view.rounding);
    if (!crossings) return;
    draw.caps = CapsNeeded::no;
    draw.start = draw.counted == Counted::all          ? crossings->all()
                 : draw.counted == Counted::facingAway ? crossings->facingAway
                                                       : crossings->lightFacing;
}

/// Adds a plane if the light is on its inner side, where dot(plane, (p, 1)) > 0.
void addEnd(const glm::dvec4& plane, PlanView& view) {
    const double ofLight = glm::dot(plane, view.light);
    const glm::dvec4 terms = glm::abs(plane) * glm::abs(view.light);
    const double size = terms.x + terms.y + terms.z + terms.w;
    if (ofLight > 1e-3 * size) view.ends.push_back(plane / ofLight);
}

/// The world-space box of all rays from the near rectangles to the visible geometry. Volumes that
/// are cut off outside it count the same.
Box seenThrough(const FrameView& view, const PlanView& here, const glm::dmat4& worldFromBatch) {
    Box box = view.visible;
    if (!view.frustum.orthographic) box.add(view.frustum.position());
    for (const auto& rectangle : {here.fromNear.corners, here.fromNearest.corners})
        for (const glm::dvec3& corner : rectangle)
            box.add(glm::dvec3(worldFromBatch * glm::dvec4(corner, 1.0)));
    return box;
}

/// Adds the planes of a box in the world, slightly enlarged.
void addEnds(const Box& box, const glm::dmat4& worldFromBatch, PlanView& view) {
    for (glm::length_t axis = 0; axis < 3; ++axis)
        for (const double side : {1.0, -1.0}) {
            glm::dvec4 plane(0.0);
            plane[axis] = side;
            plane.w = (side > 0.0 ? -box.low[axis] : box.high[axis]) + endMargin * box.diagonal();
            addEnd(glm::transpose(worldFromBatch) * plane, view);
        }
}

/// Least distance of the box below the light, as a share of the light's height.
double leastBelowLight(double highest, const PlanView& view) {
    return 1.0 - highest * view.light.w;
}

/// The end that the cluster's volumes reach soonest; -1 if no end suits all of the cluster.
int endFor(const Box& bounds, const PlanView& view) {
    int best = -1;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < view.ends.size(); ++i) {
        if (!mayEndAt(bounds, view, i)) continue;
        const double highest = largestOver(bounds, view.ends[i]);
        const double reach = highest / leastBelowLight(highest, view);
        if (reach >= least) continue;
        least = reach;
        best = static_cast<int>(i);
    }
    return best;
}

/// The reason to leave out casters within the box; null if there is none.
std::optional<LeftOut::Why> leftOutFor(const Box& bounds, const PlanView& view) {
    for (std::size_t i = 0; i < view.planes.size(); ++i)
        if (isVolumeOutside(bounds, view.planes[i], view.light))
            return i + 1 == view.planes.size() ? LeftOut::Why::tooDeep : LeftOut::Why::outsideView;
    if (isBeyond(bounds, glm::dvec3(view.light), view.range)) return LeftOut::Why::tooFar;
    for (const glm::dvec4& plane : view.cone)
        if (isOutside(bounds, plane)) return LeftOut::Why::outsideCone;
    for (const glm::dvec4& plane : view.between)
        if (isOutside(bounds, plane)) return LeftOut::Why::besideVisible;
    return std::nullopt;
}

/// The direction of a cluster's volumes along the viewing direction.
enum class Leading { deeper, nearer, both };

Leading leadingOf(const ShadowCluster& cluster, const PlanePairShadow& shadow,
                  const PlanView& view) {
    const glm::dvec4& depthLeft = view.planes.back(); // depth left to the farthest visible geometry
    const double ofLight = glm::dot(depthLeft, view.light);
    if (view.light.w == 0.0) return ofLight >= 0.0 ? Leading::deeper : Leading::nearer;
    // Test the corners themselves: the box of a cluster that is cut at a slant reaches farther.
    const double margin = roundingOf(cluster.bounds, depthLeft);
    bool deeper = true, nearer = true;
    for (std::uint32_t i = cluster.caps.first; i < cluster.caps.end(); ++i)
        for (const glm::vec3& corner : {shadow.caps[i].a, shadow.caps[i].b, shadow.caps[i].c}) {
            const double left = glm::dot(depthLeft, glm::dvec4(corner, 1.0));
            deeper = deeper && left <= ofLight + margin;
            nearer = nearer && left >= ofLight - margin;
        }
    return deeper ? Leading::deeper : nearer ? Leading::nearer : Leading::both;
}

/// Adapts a cluster of an orthographic view that would be counted behind surfaces (docs/method.md,
/// C33).
void keepBeforeFarPlane(const ShadowCluster& cluster, const PlanePairShadow& shadow,
                        const PlanView& view, ClusterPlan& draw) {
    switch (leadingOf(cluster, shadow, view)) {
    case Leading::nearer:
        return;
    case Leading::deeper:
        draw.caps = cluster.alphaTested ? CapsNeeded::cutoutsAlone : CapsNeeded::no;
        return;
    case Leading::both:
        throw Error(ExitStatus::unavailable,
                    "A point light stands among the scene's depths, before some casters and behind "
                    "others, where an orthographic picture can't count its shadows.");
    }
}

/// Adds a cluster to those left out, joined to its neighbour if the reason is the same.
void leaveOut(std::vector<LeftOut>& all, std::uint32_t cluster, LeftOut::Why why) {
    if (!all.empty() && all.back().clusters.end() == cluster && all.back().why == why)
        ++all.back().clusters.count;
    else
        all.push_back({{cluster, 1}, why});
}

} // namespace

PlanView planView(const FrameView& view, const DepthSlice& slice, const Light& light,
                  const glm::dmat4& worldFromBatch, int mantissaBits) {
    const glm::dmat4 viewFromBatch = view.frustum.viewFromWorld * worldFromBatch;
    const glm::dmat4 batchFromView = glm::inverse(viewFromBatch);
    PlanView result;
    result.rounding = dotRounding(mantissaBits);
    result.culls = view.culls;
    result.light = placeInObject(light, worldFromBatch);
    result.range = rangeInObject(light, worldFromBatch);
    if (light.isSpot())
        for (const glm::dvec4& plane : planesAround(light))
            result.cone.push_back(glm::transpose(worldFromBatch) * plane);
    result.fromNear = {rectangleAt(slice.near, view.frustum, batchFromView), result.light};
    result.beforeNearest = volumeBefore(view.near(), view.frustum, batchFromView);
    result.fromNearest = {result.beforeNearest.corners, result.light};
    result.eye = result.beforeNearest.light;
    result.planes = viewPlanes(view, slice, worldFromBatch);
    addEnd(result.planes.back(), result);
    if (!view.visible.empty())
        addEnds(seenThrough(view, result, worldFromBatch), worldFromBatch, result);
    return result;
}

void findPlanesBetween(const FrameView& view, const Light& light, std::vector<glm::dvec4>& planes) {
    Box box = view.visible;
    if (box.empty()) return planes.clear();
    const double margin =
        endMargin * box.diagonal() +
        placingError * std::max(largestComponent(box.low), largestComponent(box.high));
    box.low -= margin;
    box.high += margin;
    findPlanesBetween(light.position, box, planes);
}

std::optional<LeftOut> leftOutWhole(const PlanePairShadow& shadow, const glm::dmat4& worldFromBatch,
                                    const PlanView& inWorld, std::span<const glm::dvec4> between) {
    Box bounds;
    for (const ShadowCluster& cluster : shadow.clusters)
        bounds.add(cluster.bounds);
    if (bounds.empty()) return std::nullopt;
    PlanView view;
    view.light = glm::inverse(worldFromBatch) * inWorld.light;
    for (std::size_t i = 0; i < view.planes.size(); ++i)
        view.planes[i] = glm::transpose(worldFromBatch) * inWorld.planes[i];
    if (std::isfinite(inWorld.range)) view.range = rangeInObject(inWorld.range, worldFromBatch);
    for (const glm::dvec4& plane : inWorld.cone)
        view.cone.push_back(glm::transpose(worldFromBatch) * plane);
    view.between = between;
    const auto why = leftOutFor(bounds, view);
    if (!why) return std::nullopt;
    return LeftOut{{0, static_cast<std::uint32_t>(shadow.clusters.size())}, *why};
}

bool mayEndAt(const Box& bounds, const PlanView& view, std::size_t end) {
    return leastBelowLight(largestOver(bounds, view.ends[end]), view) > leastBelow;
}

glm::vec4 endOf(const ClusterPlan& draw, std::span<const glm::dvec4> ends) {
    return draw.end < 0 ? glm::vec4(0, 0, 0, 1)
                        : glm::vec4(ends[static_cast<std::size_t>(draw.end)]);
}

void mergeAlike(VolumePlan& plan) {
    std::size_t merged = 0;
    for (std::size_t i = 0; i < plan.drawn.size(); ++i) {
        const ClusterPlan draw = plan.drawn[i];
        if (merged > 0) {
            ClusterPlan& last = plan.drawn[merged - 1];
            if (last.clusters.end() == draw.clusters.first && last.drawnLike(draw)) {
                last.clusters.count += draw.clusters.count;
                last.start += draw.start;
                continue;
            }
        }
        plan.drawn[merged++] = draw;
    }
    plan.drawn.resize(merged);
}

void planClusters(const PlanePairShadow& shadow, const PlanView& view,
                  std::span<const std::uint8_t> solids, ClusterMemory& memory, VolumePlan& plan) {
    const bool oneNear = view.fromNear.corners == view.fromNearest.corners;
    ViewVolumes volumes(view);
    plan.clear();
    plan.drawn.reserve(shadow.clusters.size());
    plan.leftOut.reserve(shadow.clusters.size());
    for (std::uint32_t i = 0; i < shadow.clusters.size(); ++i) {
        const ShadowCluster& cluster = shadow.clusters[i];
        if (const auto why = leftOutFor(cluster.bounds, view)) {
            leaveOut(plan.leftOut, i, *why);
            continue;
        }
        findTouching(volumes.fromNear(), cluster, shadow, memory.near);
        if (!oneNear) findTouching(volumes.fromNearest(), cluster, shadow, memory.nearest);
        ClusterPlan draw;
        draw.clusters = {i, 1};
        const bool culled =
            mayBeCulled(cluster, shadow, view, volumes, !solids.empty() && solids[i] != 0);
        const auto counted = countedOf(cluster, shadow, view, volumes,
                                       oneNear ? memory.near : memory.nearest, culled);
        if (!counted) {
            plan.clear();
            plan.fullyShadowedBy = i;
            return;
        }
        draw.counted = *counted;
        decideCaps(cluster, shadow, view, volumes, memory.near, draw);
        if (draw.zFail() && view.eye.w == 0.0) keepBeforeFarPlane(cluster, shadow, view, draw);
        if (!draw.zFail()) draw.end = endFor(cluster.bounds, view);
        const bool inView =
            std::none_of(view.planes.begin(), view.planes.begin() + 5,
                         [&](const glm::dvec4& p) { return isOutside(cluster.bounds, p); });
        draw.frontCaps = (draw.zFail() || draw.caps == CapsNeeded::cutoutsAlone) && inView;
        draw.backCaps = draw.zFail() && mayBackCapsBeSeen(cluster.bounds, view);
        const glm::dvec4 beforeNear = -view.planes[4]; // >= 0 before the near plane
        draw.nearDiscard = draw.zFail() && draw.frontCaps && !isOutside(cluster.bounds, beforeNear);
        draw.fannedCaps = draw.zFail() && !cluster.alphaTested && !draw.nearDiscard &&
                          (!draw.backCaps || isOutsideOf(cluster.bounds, view.light));
        draw.culledCaps = culled && inView;
        plan.drawn.push_back(draw);
    }
}

} // namespace edgeshade
