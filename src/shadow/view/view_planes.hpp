#pragma once

#include "src/shadow/view/frame_view.hpp"

#include <array>
#include <glm/glm.hpp>

namespace edgeshade {

/// Planes around a slice, in a batch's space: left, right, bottom, top, near, and the farthest
/// visible depth; dot(plane, (p, 1)) >= 0 inside.
using ViewPlanes = std::array<glm::dvec4, 6>;

/// The planes for a batch placed by `worldFromBatch`, around FrameView::part if it is set.
ViewPlanes viewPlanes(const FrameView& view, const DepthSlice& slice,
                      const glm::dmat4& worldFromBatch);

} // namespace edgeshade
