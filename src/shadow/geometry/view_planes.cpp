#include "src/shadow/geometry/view_planes.hpp"

#include <algorithm>

namespace edgeshade {

ViewPlanes viewPlanes(const FrameView& view, const DepthSlice& slice,
                      const glm::dmat4& worldFromBatch) {
    const double aspect = static_cast<double>(view.width) / view.height;
    const glm::dmat4 rows = glm::transpose(clipFromView(view.camera, aspect, slice.near) *
                                           viewFromWorld(view.camera) * worldFromBatch);
    glm::dvec4 farthest = -rows[3]; // depth is w
    farthest.w += std::min(slice.far, view.farthestDepth) * (1.0 + 1e-3);
    return {rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1],
            rows[3] - rows[1], rows[3] + rows[2], farthest};
}

} // namespace edgeshade
