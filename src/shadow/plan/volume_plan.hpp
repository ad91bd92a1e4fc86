#pragma once

#include "preprocess/base/inline_vector.hpp"
#include "preprocess/volumes/plane_pair_data.hpp"
#include "src/shadow/lights/light_cone.hpp"
#include "src/shadow/plan/contact_caps.hpp"
#include "src/shadow/plan/ray_crossings.hpp"
#include "src/shadow/silhouette/light_facings.hpp"
#include "src/shadow/view/frame_view.hpp"
#include "src/shadow/view/view_planes.hpp"

#include <span>
#include <vector>

namespace edgeshade {

/// The triangles of a cluster that count (docs/method.md, C8).
enum class Counted {
    all,         ///< every triangle: always right
    lightFacing, ///< for a closed cluster if eye and light have the same winding numbers
    facingAway,  ///< likewise, if culled parts of it may be before visible surfaces
};

/// Why volumes need caps and are counted behind surfaces (z-fail).
enum class CapsNeeded {
    no,           ///< sides alone, counted before surfaces (z-pass)
    cutoutsAlone, ///< z-pass with front caps in the casters' cutouts; orthographic views only
    seenThrough,  ///< casters are alpha-tested
    nearPlaneMet, ///< a triangle may cross the near plane
    outlineMet,   ///< a shadow's outline may cross the near rectangle
    uncertain,    ///< rounding may decide, or there are too many triangles to test
};

/// How the shadow volumes of neighbouring clusters are drawn. A batch's cluster plans are in order.
struct ClusterPlan {
    RecordRange clusters;
    Counted counted = Counted::all;
    CapsNeeded caps = CapsNeeded::uncertain;
    int start = 0; ///< without caps: number of volumes that contain the whole near rectangle
    int end = -1;  ///< without caps: index in PlanView::ends of the plane where volumes end; -1: at
                   ///< infinity
    bool frontCaps = true;   ///< with z-fail or cutouts: some casters may be in the view
    bool backCaps = true;    ///< with z-fail: at infinity, some of the shadow may be in the view
    bool nearDiscard = true; ///< with front caps: some casters may cross the near plane
    bool fannedCaps = false; ///< with z-fail: caps may be fans, see planClusters()
    /// Front caps of single-sided casters that show their backs are counted once more, before
    /// surfaces: culled parts of casters may be before visible surfaces (docs/method.md, C39).
    bool culledCaps = false;

    bool drawnLike(const ClusterPlan& other) const {
        return counted == other.counted && caps == other.caps && end == other.end &&
               frontCaps == other.frontCaps && backCaps == other.backCaps &&
               nearDiscard == other.nearDiscard && fannedCaps == other.fannedCaps &&
               culledCaps == other.culledCaps;
    }
    bool zFail() const { return caps != CapsNeeded::no && caps != CapsNeeded::cutoutsAlone; }
};

/// Neighbouring clusters that are not drawn.
struct LeftOut {
    enum class Why {
        outsideView,   ///< their volumes miss the view
        tooDeep,       ///< they begin behind everything visible
        tooFar,        ///< they are out of the light's range
        outsideCone,   ///< they are outside the light's cone
        besideVisible, ///< they are not between the light and anything visible
    };
    RecordRange clusters;
    Why why = Why::outsideView;
};

/// The clusters of a batch that are drawn for one light, and those left out.
struct VolumePlan {
    std::vector<ClusterPlan> drawn; ///< in the order of clusters, as in `leftOut`
    std::vector<LeftOut> leftOut;
    /// A closed cluster with the eye on one side of it and the light on the other. Everything
    /// visible is in its shadow, so nothing is drawn.
    std::optional<std::uint32_t> fullyShadowedBy;

    /// Empties it, and keeps its memory.
    void clear() {
        drawn.clear();
        leftOut.clear();
        fullyShadowedBy.reset();
    }
};

/// Some planes that volumes may end at.
using EndPlanes = InlineVector<glm::dvec4, 7>;

/// Light and view in a batch's space: everything that decides how its clusters are drawn.
struct PlanView {
    glm::dvec4 light;
    double range = std::numeric_limits<double>::infinity(); ///< see rangeInObject()
    ConePlanes cone; ///< of a spot: planes around the space that it lights; see planesAround()
    glm::dvec4 eye;  ///< origin of the picture's rays; at infinity (w = 0) if orthographic
    NearClipVolume fromNear;      ///< from the slice's near plane to the light
    NearClipVolume fromNearest;   ///< from the nearest near plane to the light
    NearClipVolume beforeNearest; ///< from the nearest near plane to the eye
    ViewPlanes planes;
    /// Planes that have the eye, everything visible and the light on one side, scaled so that the
    /// light's height is 1: dot(plane, light) = 1. See pushedTo() of the shaders.
    EndPlanes ends;
    double rounding = dotRounding(23); ///< error of the shaders' dot products with the light
    ContactCaps contact;               ///< the touched caps; planView() leaves it empty
    /// Planes with everything between the light and the visible geometry on their inner sides;
    /// planView() leaves it empty.
    std::span<const glm::dvec4> between;
    bool culls = false; ///< see Scene
};

/// The view of a batch placed by `worldFromBatch`, which must be invertible. `mantissaBits`:
/// precision of the vertex shader's floats.
PlanView planView(const FrameView& view, const DepthSlice& slice, const Light& light,
                  const glm::dmat4& worldFromBatch, int mantissaBits = 23);

/// Fills `planes` with planes in the world that have everything between the light and the view's
/// visible geometry on their inner sides. None if that geometry is unknown.
void findPlanesBetween(const FrameView& view, const Light& light, std::vector<glm::dvec4>& planes);

/// Leaves out all clusters of a batch placed by `worldFromBatch` at once if the box around them
/// allows it; null otherwise. `inWorld`: planView() for the world itself. `between`:
/// PlanView::between, in the batch's space.
std::optional<LeftOut> leftOutWhole(const PlanePairShadow& shadow, const glm::dmat4& worldFromBatch,
                                    const PlanView& inWorld, std::span<const glm::dvec4> between);

/// Whether the volumes of all casters within the box may end at the view's plane `end`
/// (docs/method.md, C14).
bool mayEndAt(const Box& bounds, const PlanView& view, std::size_t end);

/// The plane at which such volumes end, for the shaders. `ends`: PlanView::ends.
glm::vec4 endOf(const ClusterPlan& draw, std::span<const glm::dvec4> ends);

/// Arrays that planning uses again for the next batch.
struct ClusterMemory {
    Touched near, nearest;
};

/// Decides how each cluster is drawn, if at all, each by itself; mergeAlike() joins them. A pure
/// function that reuses the memory of `plan`.
///
/// - A cluster is not drawn if it is out of the light's range or cone, or if its volume (its box
///   extruded away from the light) certainly misses the view or begins behind everything visible.
/// - It is drawn without caps, before surfaces (z-pass), if the same number of its volumes contains
///   every point of the near rectangle. That number is 0 if the hull of rectangle and light is
///   apart from all its triangles, and otherwise the number of layers in between, see
///   ray_crossings.hpp. Alpha-tested casters always get caps, since the eye sees volumes through
///   them. z-pass volumes end at a plane beyond everything visible, if one suits the whole cluster.
/// - Fans may replace its caps: triangles that join the silhouette edges to the middle of the
///   cluster's box. A fan has the same outline as the casting triangles, and at infinity only
///   outlines count. Fan and triangles together are closed, so they cover each direction from the
///   eye (front caps) or from the light (back caps) as often as they wind around eye or light. That
///   is 0 for a point outside the box. For front caps the box must be beyond the near plane.
///   Alpha-tested casters have no fans.
/// - Only its light-facing triangles count if it is closed, no triangle of it is between the eye
///   and the nearest near plane, and eye and light have the same winding numbers (docs/method.md,
///   C8). If these certainly differ, everything visible is in the cluster's shadow.
/// - If culled casters may be before visible surfaces, their caps are also counted in place, and
///   the triangles that face away from the light count instead of the light-facing ones
///   (docs/method.md, C39). Solids with the eye outside need none of this.
///
/// The far plane of an orthographic view is not at infinity. Parts of a volume behind it are lost,
/// so volumes that cross it can't be counted behind surfaces; but no caster is before the near
/// plane. So volumes that lead away from the viewer are counted before surfaces, with front caps in
/// the casters' cutouts. Volumes that lead towards the viewer are counted behind surfaces where
/// they need caps (docs/method.md, C33). Throws Error(unavailable) if the light is between the
/// depths of a cluster that needs caps. `solids`: findSolids() of the shadow's clusters; empty:
/// none is known to be solid.
void planClusters(const PlanePairShadow& shadow, const PlanView& view,
                  std::span<const std::uint8_t> solids, ClusterMemory& memory, VolumePlan& plan);

/// Merges neighbouring clusters that are drawn alike.
void mergeAlike(VolumePlan& plan);

} // namespace edgeshade
