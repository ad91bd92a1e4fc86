#pragma once

#include "preprocess/base/box.hpp"
#include "src/shadow/geometry/interval.hpp"

#include <limits>

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
};

} // namespace edgeshade
