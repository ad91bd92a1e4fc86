#include "src/shadow/plan/stencil_start.hpp"

namespace edgeshade {

void StencilStart::add(const VolumePlan& plan) {
    for (const ClusterPlan& drawn : plan.drawn)
        count_ += drawn.start;
}

} // namespace edgeshade
