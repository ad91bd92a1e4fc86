#pragma once

#include "src/shadow/plan/volume_plan.hpp"
#include "src/shadow/silhouette/silhouette_list.hpp"

#include <memory>

namespace edgeshade {

/// What of one batch is drawn. The eye and the last three are those of plane-pair records.
struct BatchPlan {
    std::size_t batch = 0; ///< its index in the scene
    glm::dmat4 worldFromBatch{1.0};
    glm::vec4 light{0.0f}; ///< in its space
    glm::vec4 eye{0.0f};   ///< likewise, homogeneous
    float reach = 0.0f;    ///< ContactCaps'
    std::shared_ptr<const PlanePairShadow> shadow = nullptr;
    VolumePlan volumes = {}; ///< which clusters are drawn, which are left out, how and why
    EndPlanes ends = {};     ///< where volumes may end: PlanView's
    /// Where draws take their pairs from; null: from all, or nothing is drawn. Holds until the next
    /// frame is planned.
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
