#pragma once

#include "src/shadow/plan/count_plan.hpp"

namespace edgeshade {

struct GpuBatch;
struct Light;

/// The plan of records that know triangles by their corners, before anything is drawn of them.
BatchPlan cornerRecordPlan(const GpuBatch& batch, std::size_t index, const Light& light);

/// Whether the light touches some caster (docs/method.md, C47): records that know triangles by
/// their corners need programs of their own then, so that others need not ask.
inline bool isInContact(const BatchPlan& plan) {
    return plan.reach > 0.0f;
}

} // namespace edgeshade
