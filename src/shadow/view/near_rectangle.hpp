#pragma once

#include "src/shadow/geometry/separation.hpp"
#include "src/shadow/view/frame_view.hpp"

namespace edgeshade {

/// Corners of the picture at a depth, in the space of `spaceFromView`.
inline std::array<glm::dvec3, 4> rectangleAt(double depth, const Frustum& frustum,
                                             const glm::dmat4& spaceFromView) {
    const double unit = frustum.orthographic ? 1.0 : depth;
    std::array<glm::dvec3, 4> corners;
    const std::array<glm::dvec2, 4> signs = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
    for (std::size_t i = 0; i < 4; ++i)
        corners[i] =
            glm::dvec3(spaceFromView * glm::dvec4(unit * frustum.windowAt(signs[i]), -depth, 1.0));
    return corners;
}

/// The volume between the eye and the picture at a depth, in that space.
inline NearClipVolume volumeBefore(double depth, const Frustum& frustum,
                                   const glm::dmat4& spaceFromView) {
    return {rectangleAt(depth, frustum, spaceFromView),
            frustum.orthographic ? spaceFromView[2] : spaceFromView[3]};
}

} // namespace edgeshade
