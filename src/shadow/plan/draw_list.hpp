#pragma once

#include "src/shadow/plan/batch_plan.hpp"
#include "src/shadow/plan/volume_draw.hpp"

namespace edgeshade {

/// The draws of a plan: those that count twice, and the others.
struct DrawList {
    std::vector<VolumeDraw> twice, once; ///< in order
};

/// Turns what was decided for a batch's clusters into draws, in their order, and appends these.
/// `index`: of the batch in the plan; `fanned`: memory to use.
///
/// Sides: a single record counts once. So does a pair where one triangle of a silhouette edge
/// casts. Where both cast it counts twice, but once where the light is in the plane of either.
///
/// Caps: where ClusterPlan::fannedCaps allows it and fewer vertices are needed for them, fans of
/// the potential silhouettes; else those triangles that cast, only those that may face the light
/// where that is known. Those of ClusterPlan::culledCaps come besides, of single-sided casters.
void appendDraws(const BatchPlan& batch, std::size_t index, const std::vector<Material>& materials,
                 std::vector<std::uint8_t>& fanned, DrawList& draws);

} // namespace edgeshade
