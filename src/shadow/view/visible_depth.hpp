#pragma once

#include "src/shadow/geometry/interval.hpp"
#include "src/shadow/view/frustum.hpp"

#include <limits>
#include <optional>

namespace edgeshade {

/// Distances along the viewing direction between which something is visible; empty (nearest above
/// farthest) where nothing is.
struct DepthRange {
    double nearest = std::numeric_limits<double>::infinity();
    double farthest = 0.0;

    void add(double depth) {
        nearest = std::min(nearest, depth);
        farthest = std::max(farthest, depth);
    }
    bool empty() const { return nearest > farthest; }
    bool contains(double from, double to) const { return nearest <= from && to <= farthest; }
};

/// How far to the right of the viewing direction and above it something is, as Frustum's window
/// tells it: per unit of depth; of an orthographic picture, whatever the depth.
struct Slopes {
    Interval right, up;
};

/// Where surfaces are that may be visible.
struct VisiblePart {
    DepthRange depth;
    Box box;       ///< in the world
    Slopes slopes; ///< with what a GL's floats may add

    void add(const VisiblePart& other) {
        if (other.depth.empty()) return;
        depth.add(other.depth.nearest);
        depth.add(other.depth.farthest);
        box.add(other.box.low);
        box.add(other.box.high);
        slopes.right.add(other.slopes.right);
        slopes.up.add(other.slopes.up);
    }
};

/// Where surfaces of one of the scene's batches are within the frustum, a little widened. Exact but
/// for rounding: triangles are clipped to it, and left out where the scene culls them, if that is
/// beyond doubt.
VisiblePart visiblePart(const Scene& scene, const Batch& batch, const Frustum& frustum);

/// Of a batch whose vertices are within a box of its space, and of what is known of others: a bound
/// below its visible depths, infinity where it is out of the frustum, if it adds nothing to that in
/// either case. Null: visiblePart() has to look.
std::optional<double> nearestOfKnown(const VisiblePart& known, const Box& box,
                                     const glm::dmat4& worldFromBatch, const Frustum& frustum);

/// Whether the picture's eye, which may be at infinity, is above the ground: else it isn't seen.
bool isAboveGround(const Frustum& frustum, const Batch& ground);

} // namespace edgeshade
