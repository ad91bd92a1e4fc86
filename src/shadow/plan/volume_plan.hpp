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

/// Which triangles of a cluster cast (docs/method.md, C8).
enum class Counted {
    all,         ///< every triangle: always right
    lightFacing, ///< of a closed cluster around which eye and light have the same winding numbers
    facingAway,  ///< the same, where some of it may be culled before what is visible
};

/// Why volumes are drawn with caps and counted behind surfaces (z-fail).
enum class CapsNeeded {
    no,           ///< sides alone, counted before surfaces (z-pass)
    cutoutsAlone, ///< z-pass, and front caps in the cutouts of casters; of orthographic pictures
    seenThrough,  ///< casters are alpha-tested
    nearPlaneMet, ///< a triangle may cross the near plane
    outlineMet,   ///< a shadow's outline may run through the near rectangle
    uncertain,    ///< rounding may decide, or there are too many triangles to tell
};

/// How shadow volumes of some neighbouring clusters are drawn. Those of one batch are in order.
struct ClusterPlan {
    RecordRange clusters;
    Counted counted = Counted::all;
    CapsNeeded caps = CapsNeeded::uncertain;
    int start = 0; ///< without caps: volumes that the whole near rectangle is in
    int end = -1;  ///< without caps: which of PlanView::ends volumes end at; -1: at infinity
    bool frontCaps = true;   ///< with z-fail or cutouts: some casters may be in the view
    bool backCaps = true;    ///< with z-fail: at infinity, some of its shadow may be in the view
    bool nearDiscard = true; ///< with front caps: some casters may cross the near plane
    bool fannedCaps = false; ///< with z-fail: caps may be fans, see planVolumes()
    /// Front caps of single-sided casters that show their backs are counted once more, before
    /// surfaces: what the eye doesn't see of casters may be before what it sees (docs/method.md,
    /// C39).
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
        outsideView, ///< their volumes miss it
        tooDeep,     ///< they begin behind everything that is visible
        tooFar,      ///< out of the light's range
        outsideCone, ///< beside the light's cone
    };
    RecordRange clusters;
    Why why = Why::outsideView;
};

/// What is drawn of a batch for one light, and what is not.
struct VolumePlan {
    std::vector<ClusterPlan> drawn; ///< in the order of clusters; as are those left out
    std::vector<LeftOut> leftOut;
    /// A closed cluster with the eye on one side of it and the light on the other: everything
    /// visible is in its shadow, and nothing need be drawn.
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

/// Light and view in a batch's space: all that decides how its clusters are drawn.
struct PlanView {
    glm::dvec4 light;
    double range = std::numeric_limits<double>::infinity(); ///< of the light; see rangeInObject()
    ConePlanes cone; ///< of a spot: planes around what it lights; see planesAround()
    glm::dvec4 eye;  ///< where the picture's rays come from; at infinity (w = 0) if orthographic
    NearClipVolume fromNear;      ///< from the slice's near plane to the light
    NearClipVolume fromNearest;   ///< from the nearest near plane to the light
    NearClipVolume beforeNearest; ///< from the nearest near plane to the eye
    ViewPlanes planes;
    /// Planes with the eye, all that is visible and the light on one side; scaled so that the light
    /// is 1 and they are 0 high: dot(plane, light) = 1. See pushedTo() of the shaders.
    EndPlanes ends;
    double rounding = dotRounding(23); ///< of the shaders' dot products with the light
    ContactCaps contact;               ///< what the light touches; planView() leaves it empty
    bool culls = false;                ///< see Scene
};

/// The view of a batch placed by `worldFromBatch`, which must be invertible. `mantissaBits`: of the
/// vertex shader's floats.
PlanView planView(const FrameView& view, const DepthSlice& slice, const Light& light,
                  const glm::dmat4& worldFromBatch, int mantissaBits = 23);

/// All clusters of records that are placed by `worldFromBatch`, where the box around them tells
/// that each is left out. `inWorld`: planView() of the world itself.
std::optional<LeftOut> leftOutWhole(const PlanePairShadow& shadow, const glm::dmat4& worldFromBatch,
                                    const PlanView& inWorld);

/// Whether volumes of all that casts within the box may end at the view's plane of that index
/// (docs/method.md, C14).
bool mayEndAt(const Box& bounds, const PlanView& view, std::size_t end);

/// The plane at which such volumes end, for the shaders. `ends`: PlanView's.
glm::vec4 endOf(const ClusterPlan& draw, std::span<const glm::dvec4> ends);

/// Decides how each cluster is drawn, if at all. A pure function:
/// - not at all where it is out of the light's range or cone, or its volume, the cluster's box away
/// from
///   the light, certainly misses the view or begins behind everything visible;
/// - without caps, before surfaces (z-pass), where every point of the near rectangle is within the
///   same number of its volumes: none where the hull of rectangle and light is apart from all of
///   the cluster's triangles, and elsewhere as many as there are layers in between, see
///   ray_crossings.hpp. Alpha-tested casters always get caps, since the eye sees volumes through
///   them. Such volumes end at a plane beyond everything visible, where there is one for all of the
///   cluster;
/// - with fans for caps, whose triangles join the silhouette edges to the middle of the cluster's
///   box. They have the same outline as the casting triangles, and at infinity only outlines count:
///   fan and triangles together are closed, so that they cover each direction from the eye (of the
///   front caps) or from the light (of the back caps) as often as they wind around eye or light,
///   which is never where that is outside of the box. For front caps the box must be beyond the
///   near plane; alpha-tested casters take none;
/// - light-facing triangles alone where the cluster is closed, no triangle of it is between the eye
///   and the nearest near plane, and eye and light have the same winding numbers (docs/method.md,
///   C8). Where these certainly differ, the cluster seals the eye off from the light;
/// - where casters are culled that may be before what is visible (those of solids with the eye
///   outside are not), with their caps counted where they
///   are, and triangles that face away from the light in place of the light-facing ones
///   (docs/method.md, C39).
///
/// The far plane of an orthographic picture is no infinity: what of a volume is behind it is lost,
/// and may not be counted behind surfaces. But none of its casters is before the near plane. So
/// volumes that lead away from the viewer are counted before surfaces, with front caps in the
/// cutouts of casters, and those that lead towards the viewer behind them, if need be
/// (docs/method.md, C33). Throws Error(unavailable) where the light stands among a cluster's depths
/// and it is in need.
/// `solids`: what findSolids() says of the shadow's clusters; nothing: none is known.
VolumePlan planVolumes(const PlanePairShadow& shadow, const PlanView& view,
                       std::span<const std::uint8_t> solids = {});

/// Arrays that planning uses again for the next batch.
struct ClusterMemory {
    Touched near, nearest;
};

/// The same with each cluster that is drawn by itself, for those who decide further. Reuses the
/// memory of `plan`.
void planClusters(const PlanePairShadow& shadow, const PlanView& view,
                  std::span<const std::uint8_t> solids, ClusterMemory& memory, VolumePlan& plan);

/// Puts neighbouring clusters together that are drawn alike.
void mergeAlike(VolumePlan& plan);

} // namespace edgeshade
