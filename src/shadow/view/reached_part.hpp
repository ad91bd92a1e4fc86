#pragma once

#include "src/shadow/view/frame_view.hpp"

namespace edgeshade {

/// The part of a view that a light can change, as a view without lights: the window around
/// lightReach(), no deeper than the light reaches, with the visible geometry limited to the box of
/// its ball (docs/method.md, C22). If shadows are right in this view, they are right for the light.
/// For a light that reaches everywhere it is the whole view.
FrameView reachedPart(const FrameView& view, const DepthSlice& slice, const Light& light);

} // namespace edgeshade
