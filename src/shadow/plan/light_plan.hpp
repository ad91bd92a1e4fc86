#pragma once

#include "src/shadow/plan/volume_plan.hpp"

#include <functional>
#include <vector>

namespace edgeshade {

/// What a plan is made of: one batch and where it is.
struct PlacedShadow {
    std::size_t batch = 0; ///< its index in the scene
    const AdaptedShadow* shadow = nullptr;
    glm::dmat4 worldFromBatch{1.0};
};

/// All shadow volumes of one light in one depth slice, and why they are drawn as they are.
struct LightPlan {
    struct Batch {
        std::size_t batch = 0;
        PlanView view; ///< in its space
        VolumePlan volumes;
    };
    std::vector<Batch> batches;

    /// The stencil's count before any volume is drawn.
    int start() const;

    /// Whether something seals the eye off from the light, so that everything visible is in shadow.
    bool sealed() const;
};

/// A pure function of scene, light and camera: needs no GL. `mantissaBits`: of the vertex shader's
/// floats.
LightPlan planLight(const std::vector<PlacedShadow>& casters, const FrameView& view,
                    const DepthSlice& slice, const Light& light, int mantissaBits);

} // namespace edgeshade
