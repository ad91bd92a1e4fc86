#pragma once

#include "src/shadow/plan/batch_plan.hpp"
#include "src/shadow/plan/fill_cost.hpp"

namespace edgeshade {

/// Where volumes that are counted before surfaces end.
enum class VolumeEnds {
    automatic,  ///< by cost where hardware draws, at planes where the processor does
    byCost,     ///< at a plane beyond everything visible or at infinity, by estimate
    atPlanes,   ///< at the plane that is reached soonest, wherever one suits
    atInfinity, ///< at none
};

/// Decides where the volumes of a batch's clusters end that are counted before surfaces, each by
/// itself in `batch.volumes.drawn` still: at infinity, where the sides of a directional light are
/// one triangle each, or at a plane that suits the cluster, where they are two and shorter. All of
/// these count alike (docs/method.md, C14). By cost, a few silhouette edges of every cluster tell
/// what each choice takes, and neighbours change it only where that is worth a draw more.
/// Where no silhouettes are known planes stay that are reached soonest.
void chooseEnds(BatchPlan& batch, const PlanView& view, VolumeEnds ends, const FillMeter& meter,
                const FillWeights& weights);

} // namespace edgeshade
