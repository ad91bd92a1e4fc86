#pragma once

#include "src/shadow/plan/batch_plan.hpp"
#include "src/shadow/scissors/box_placer.hpp"
#include "src/shadow/scissors/visible_points.hpp"

namespace edgeshade {

/// Finds rectangles around what is visible of the shadows of a batch's clusters (docs/method.md,
/// C45).
class ClusterScissors {
  public:
    /// Both must outlive it.
    ClusterScissors(const BatchPlan& batch, const VisiblePoints& visible);

    /// Around all visible points that may be in the cluster's volumes: what the light has behind
    /// boxes around some 32 of its triangles each (PlanePairShadow::leaves). Empty: there are none
    /// for certain.
    PixelRectangle of(const ShadowCluster& cluster) const;

  private:
    const std::vector<Box>& leaves_;
    const VisiblePoints& visible_;
    BoxPlacer placer_;
};

} // namespace edgeshade
