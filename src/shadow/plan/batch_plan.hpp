#pragma once

#include "src/shadow/plan/volume_plan.hpp"
#include "src/shadow/silhouette/silhouette_list.hpp"

#include <memory>

namespace edgeshade {

/// The draws planned for one batch. Only plane-pair records use the eye and the last three members.
struct BatchPlan {
    std::size_t batch = 0; ///< index in the scene
    glm::dmat4 worldFromBatch{1.0};
    glm::vec4 light{0.0f}; ///< in the batch's space
    glm::vec4 eye{0.0f};   ///< in the batch's space, homogeneous
    float reach = 0.0f;    ///< ContactCaps::reach
    std::shared_ptr<const PlanePairShadow> shadow = nullptr;
    VolumePlan volumes = {}; ///< which clusters are drawn or left out, how and why
    EndPlanes ends = {};     ///< planes where volumes may end: PlanView::ends
    /// The list that draws take their pairs from; null: they take all pairs, or nothing is drawn.
    /// Valid until the next frame is planned.
    const SilhouetteList* silhouettes = nullptr;

    /// Makes it as new, and keeps its memory.
    void clear() {
        VolumePlan kept = std::move(volumes);
        kept.clear();
        *this = {};
        volumes = std::move(kept);
    }
};

} // namespace edgeshade
