#pragma once

#include "src/shadow/view/frame_view.hpp"

namespace edgeshade {

/// What of a view a light can change, as a view of its own that has no lights: the window around
/// lightReach(), no deeper than the light reaches, and of what is visible the part in the box of
/// its ball (docs/method.md, C22). Shadows that are right there are right for the light. A light
/// that reaches everywhere has all of the view.
FrameView reachedPart(const FrameView& view, const DepthSlice& slice, const Light& light);

} // namespace edgeshade
