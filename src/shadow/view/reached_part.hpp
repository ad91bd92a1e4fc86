#pragma once

#include "src/shadow/view/frame_view.hpp"

namespace edgeshade {

/// Makes `part` the part of a view that a light can change, as a view without lights, and reuses
/// its memory. Its window is around lightReach(), and no deeper than the light reaches. Its visible
/// geometry is limited to the box of the light's ball (docs/method.md, C22). If shadows are right
/// in this view, they are right for the light. For a light that reaches everywhere it is the whole
/// view.
void findReachedPart(const FrameView& view, const DepthSlice& slice, const Light& light,
                     FrameView& part);

} // namespace edgeshade
