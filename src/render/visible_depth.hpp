#pragma once

#include "src/scene/camera.hpp"

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

/// Where surfaces are that may be visible.
struct VisiblePart {
    DepthRange depth;
    Box box; ///< in the world
};

/// Where the batch's surfaces are within the picture's pyramid, a little widened. Exact but for
/// rounding: triangles are clipped to the pyramid.
VisiblePart visiblePart(const Batch& batch, const Camera& camera, double aspect);

} // namespace edgeshade
