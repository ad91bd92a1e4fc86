#pragma once

#include "src/shadow/plan/count_plan.hpp"

namespace edgeshade::test {

/// A scene's records, one set per batch, with the batches' placement.
inline std::vector<PlacedShadow>
placedShadows(const Scene& scene,
              const std::vector<std::shared_ptr<const PlanePairShadow>>& shadows) {
    std::vector<PlacedShadow> placed;
    for (std::size_t i = 0; i < shadows.size(); ++i)
        placed.push_back({i, shadows[i], scene.batches[i].worldFromBatch});
    return placed;
}

inline std::vector<PlacedShadow> placedShadows(const Scene& scene, bool castMasked = false) {
    return placedShadows(scene, buildPlanePairs(scene, castMasked));
}

} // namespace edgeshade::test
