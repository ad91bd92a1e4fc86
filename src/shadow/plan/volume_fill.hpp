#pragma once

#include "src/shadow/plan/fill_cost.hpp"
#include "src/shadow/plan/frame_plan.hpp"

namespace edgeshade {

/// What all draws of a plan of plane-pair records take in a slice of the view, where `reach` may be
/// drawn.
FillCost fillOf(const CountPlan& plan, const FrameView& view, const DepthSlice& slice,
                const PixelRectangle& reach);

/// The same of all lights and slices of a frame. `view`: the one that was planned for.
FillCost fillOf(const FramePlan& plan, const FrameView& view);

} // namespace edgeshade
