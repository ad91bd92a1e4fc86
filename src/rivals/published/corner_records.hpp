#pragma once

#include "src/shadow/plan/count_plan.hpp"

namespace edgeshade {

struct GpuBatch;
struct Light;

/// The plan of a batch whose records hold triangles by their corners, without any draws yet.
BatchPlan cornerRecordPlan(const GpuBatch& batch, std::size_t index, const Light& light);

/// Whether the light touches some caster (docs/method.md, C47). Records with corners then need
/// programs of their own, so that the usual programs need no test.
inline bool isInContact(const BatchPlan& plan) {
    return plan.reach > 0.0f;
}

} // namespace edgeshade
