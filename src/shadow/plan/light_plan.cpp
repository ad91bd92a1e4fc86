#include "src/shadow/plan/light_plan.hpp"

#include <algorithm>

namespace edgeshade {

int LightPlan::start() const {
    int sum = 0;
    for (const Batch& batch : batches)
        sum += batch.volumes.start();
    return sum;
}

bool LightPlan::sealed() const {
    return std::any_of(batches.begin(), batches.end(),
                       [](const Batch& batch) { return batch.volumes.sealed.has_value(); });
}

LightPlan planLight(const std::vector<PlacedShadow>& casters, const FrameView& view,
                    const DepthSlice& slice, const Light& light, int mantissaBits) {
    LightPlan plan;
    for (const PlacedShadow& caster : casters) {
        const PlanView here = planView(view, slice, light, caster.worldFromBatch, mantissaBits);
        plan.batches.push_back({caster.batch, here, planVolumes(*caster.shadow, here)});
    }
    return plan;
}

} // namespace edgeshade
