#pragma once

#include "src/shadow/plan/volume_plan.hpp"

namespace edgeshade::test {

/// planClusters() with clusters merged that are drawn alike; none is known to be solid.
inline VolumePlan planVolumes(const PlanePairShadow& shadow, const PlanView& view) {
    VolumePlan plan;
    ClusterMemory memory;
    planClusters(shadow, view, {}, memory, plan);
    mergeAlike(plan);
    return plan;
}

} // namespace edgeshade::test
