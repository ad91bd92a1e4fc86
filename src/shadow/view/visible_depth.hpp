#pragma once

#include "src/shadow/geometry/interval.hpp"
#include "src/shadow/view/frustum.hpp"

#include <limits>
#include <optional>

namespace edgeshade {

/// Range of distances along the viewing direction that contains visible geometry; empty (nearest
/// above farthest) if there is none.
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

/// Offsets to the right of the viewing direction and above it, in the units of Frustum's window:
/// per unit of depth, or for an orthographic picture at any depth.
struct Slopes {
    Interval right, up;
};

/// Bounds of surfaces that may be visible.
struct VisiblePart {
    DepthRange depth;
    Box box;       ///< in the world
    Slopes slopes; ///< with a margin for a GL's floats

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

/// Bounds of a batch's surfaces within the frustum, which is widened slightly. Exact except for
/// rounding: triangles are clipped to it, and omitted if the scene certainly culls them.
VisiblePart visiblePart(const Scene& scene, const Batch& batch, const Frustum& frustum);

/// A shortcut for a batch whose vertices are within `box`, in its space. If its surfaces can't
/// extend the `known` bounds, returns a lower bound of its visible depths, or infinity if it is
/// outside the frustum. Null: call visiblePart().
std::optional<double> nearestOfKnown(const VisiblePart& known, const Box& box,
                                     const glm::dmat4& worldFromBatch, const Frustum& frustum);

/// Whether the picture's eye, which may be at infinity, is above the ground: otherwise the ground
/// is invisible.
bool isAboveGround(const Frustum& frustum, const Batch& ground);

} // namespace edgeshade
