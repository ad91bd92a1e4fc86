#pragma once

#include "src/shadow/view/frame_view.hpp"

namespace edgeshade {

/// The part of a view that a light can change, as a view without lights. Its window is around
/// lightReach(), and no deeper than the light reaches. Its visible geometry is limited to the box
/// of the light's ball (docs/method.md, C22). If shadows are right in this view, they are right for
/// the light. For a light that reaches everywhere it is the whole view.
FrameView reachedPart(const FrameView& view, const DepthSlice& slice, const Light& light);

/// The same into `part`, whose memory it reuses.
void findReachedPart(const FrameView& view, const DepthSlice& slice, const Light& light,
                     FrameView& part);

} // namespace edgeshade
