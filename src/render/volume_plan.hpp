#pragma once

#include "preprocess/adapted_data.hpp"
#include "src/render/frame_view.hpp"
#include "src/render/separation.hpp"

#include <array>
#include <vector>

namespace edgeshade {

/// Which triangles of a cluster cast (method, section 6.4).
enum class Counted {
    all,         ///< every triangle: always right
    lightFacing, ///< of a closed cluster around which eye and light have the same winding numbers
};

/// How shadow volumes of some neighbouring clusters are drawn. Those of one batch are in order.
struct VolumeDraw {
    RecordRange clusters;
    Counted counted = Counted::all;
    bool zFail = true;       ///< with caps, counting behind surfaces; else sides alone, before them
    bool frontCaps = true;   ///< with z-fail: some casters may be in the view
    bool nearDiscard = true; ///< with front caps: some casters may cross the near plane

    bool drawnLike(const VolumeDraw& other) const {
        return counted == other.counted && zFail == other.zFail && frontCaps == other.frontCaps &&
               nearDiscard == other.nearDiscard;
    }
};

/// Light and view in a batch's space: all that decides how its clusters are drawn.
struct PlanView {
    glm::dvec4 light;
    double range = std::numeric_limits<double>::infinity(); ///< of the light; see rangeInObject()
    glm::dvec3 eye;
    std::array<glm::dvec3, 4> nearest; ///< corners of the rectangle in the nearest near plane
    LightPyramid fromNear;             ///< from the slice's near plane to the light
    LightPyramid fromNearest;          ///< from the nearest near plane to the light
    LightPyramid beforeNearest;        ///< from the nearest near plane to the eye
    /// left, right, bottom, top, near, and the farthest that is visible: dot(plane, (p, 1)) >= 0
    /// inside.
    std::array<glm::dvec4, 6> planes;
};

/// The view of a batch placed by `worldFromBatch`, which must be invertible.
PlanView planView(const FrameView& view, const DepthSlice& slice, const Light& light,
                  const glm::dmat4& worldFromBatch);

/// Decides how each cluster is drawn, if at all. A pure function:
/// - not at all where it is out of the light's range, or its volume, the cluster's box away from
/// the light, certainly misses the view
///   or begins behind everything visible;
/// - without caps, before surfaces (z-pass), where no point of the near rectangle is within the
///   volume: the hull of rectangle and light is apart from all of the cluster's triangles. Casters
///   with holes always get caps, since the eye sees volumes through them;
/// - light-facing triangles alone where the cluster is closed, no triangle of it is between the eye
///   and the nearest near plane, and eye and light have the same winding numbers: either both are
///   outside of its bounds, or the way from the eye by the near plane to the light meets none.
std::vector<VolumeDraw> planVolumes(const AdaptedShadow& shadow, const PlanView& view);

} // namespace edgeshade
