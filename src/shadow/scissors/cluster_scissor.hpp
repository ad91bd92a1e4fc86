#pragma once

#include "src/shadow/plan/batch_plan.hpp"
#include "src/shadow/scissors/visible_points.hpp"

namespace edgeshade {

/// A rectangle around all visible points that may be in a cluster's shadow volumes
/// (docs/method.md, C45): what the light has behind boxes around some 32 of its triangles each
/// (PlanePairShadow::leaves). Empty: there are none for certain.
PixelRectangle scissorOf(const BatchPlan& batch, const ShadowCluster& cluster,
                         const VisiblePoints& visible);

} // namespace edgeshade
