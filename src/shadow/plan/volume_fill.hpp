#pragma once

#include "src/shadow/plan/fill_cost.hpp"
#include "src/shadow/plan/frame_plan.hpp"

namespace edgeshade {

/// The fill of all draws in a plan of plane-pair records, in one slice of the view. `reach`: the
/// pixels that may be drawn.
FillCost fillOf(const CountPlan& plan, const FrameView& view, const DepthSlice& slice,
                const PixelRectangle& reach);

/// As above, over all lights and slices of a frame. `view`: the one that was planned for.
FillCost fillOf(const FramePlan& plan, const FrameView& view);

} // namespace edgeshade
