#pragma once

#include "src/shadow/plan/batch_plan.hpp"
#include "src/shadow/plan/volume_draw.hpp"

namespace edgeshade {

/// The draws of a plan, separated by how often they count.
struct DrawList {
    std::vector<VolumeDraw> twice, once; ///< in order
};

/// Turns the decisions for a batch's clusters into draws, and appends these in the clusters' order.
/// `index`: the batch's index in the plan. `fanned`: scratch memory.
///
/// Sides: a single record counts once. A pair counts once if one triangle of a silhouette edge
/// casts. If both cast, it counts twice, or once where the light is in the plane of either.
///
/// Caps: fans of the potential silhouettes if ClusterPlan::fannedCaps allows them and they need
/// fewer vertices. Otherwise the casting triangles, limited to those that may face the light where
/// these are known. Caps of single-sided casters are added where ClusterPlan::culledCaps says so.
void appendDraws(const BatchPlan& batch, std::size_t index, const std::vector<Material>& materials,
                 std::vector<std::uint8_t>& fanned, DrawList& draws);

} // namespace edgeshade
