#include "src/shadow/view/view_planes.hpp"

#include <algorithm>
#include <glm/gtc/matrix_access.hpp>

namespace edgeshade {

ViewPlanes viewPlanes(const FrameView& view, const DepthSlice& slice,
                      const glm::dmat4& worldFromBatch) {
    const glm::dmat4 viewFromBatch = view.frustum.viewFromWorld * worldFromBatch;
    const glm::dmat4 rows = glm::transpose(view.clipFromView(slice) * viewFromBatch);
    glm::dvec4 farthest = glm::row(viewFromBatch, 2); // depth is -z
    farthest.w += std::min(slice.far, view.farthestDepth) * (1.0 + 1e-3);
    const PixelRectangle part = view.part.value_or(PixelRectangle{0, 0, view.width, view.height});
    // A pixel's edge in clip space, as a share of w.
    const auto edge = [](int pixel, int count) { return 2.0 * pixel / count - 1.0; };
    return {rows[0] - edge(part.x, view.width) * rows[3],
            edge(part.x + part.width, view.width) * rows[3] - rows[0],
            rows[1] - edge(part.y, view.height) * rows[3],
            edge(part.y + part.height, view.height) * rows[3] - rows[1],
            rows[3] + rows[2],
            farthest};
}

} // namespace edgeshade
