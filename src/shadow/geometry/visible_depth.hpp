#pragma once

#include "src/shadow/geometry/camera.hpp"
#include "src/shadow/geometry/interval.hpp"

#include <limits>

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
    bool contains(double from, double to) const { return nearest <= from && to <= farthest; }
};

/// How far to the right of the viewing direction and above it something is, per unit of depth.
struct Slopes {
    Interval right, up;
};

/// Where surfaces are that may be visible.
struct VisiblePart {
    DepthRange depth;
    Box box;       ///< in the world
    Slopes slopes; ///< with what a GL's floats may add
};

/// Where the batch's surfaces are within the picture's pyramid, a little widened. Exact but for
/// rounding: triangles are clipped to the pyramid.
VisiblePart visiblePart(const Batch& batch, const Camera& camera, double aspect);

} // namespace edgeshade
