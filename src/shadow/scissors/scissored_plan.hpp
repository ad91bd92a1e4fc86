#pragma once

#include "src/shadow/plan/count_plan.hpp"
#include "src/shadow/scissors/visible_points.hpp"

namespace edgeshade {

/// What a plan's sides take by estimate, in nanoseconds: from a few silhouette edges of each
/// cluster. 0 where silhouettes aren't known.
double estimatedFill(const CountPlan& plan, const FrameView& view, const DepthSlice& slice,
                     const PixelRectangle& reach, const FillWeights& weights);

/// Has a plan of plane-pair records count no more than what is visible asks for
/// (docs/method.md, C45): clusters none of whose volumes holds a visible point aren't drawn, and
/// the others nowhere but in a rectangle around those points. Volumes that the near rectangle is in
/// stay as they are. Neighbouring clusters share a rectangle where it costs less than one draw
/// more. `materials`: of the scene.
void scissorPlan(CountPlan& plan, const VisiblePoints& visible,
                 const std::vector<Material>& materials, const FrameView& view,
                 const DepthSlice& slice, const FillWeights& weights);

} // namespace edgeshade
