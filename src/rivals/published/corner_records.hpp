#pragma once

#include "src/render/volumes/volume_renderer.hpp"
#include "src/rivals/published/shadow_buffers.hpp"

#include <functional>

namespace edgeshade {

/// A batch's records in a layout that holds triangles by their corners.
const ShadowBuffers& cornerRecordsOf(const BatchVolumes& volumes, VolumeLayout layout);

/// Fills in the plan of such a layout, and reuses its memory. `append` adds the draws of one
/// batch's records; it takes the batch's index in the scene and in the plan.
void planCornerRecords(
    const GpuScene& scene, const CasterGroupInSlice& casters, VolumeLayout layout, CountPlan& plan,
    const std::function<void(const ShadowBuffers& records, std::size_t batch, std::size_t index,
                             std::vector<VolumeDraw>& draws)>& append);

/// Whether the light touches some caster (docs/method.md, C47). Records with corners then need
/// programs of their own, so that the usual programs need no test.
inline bool isInContact(const BatchPlan& plan) {
    return plan.reach > 0.0f;
}

} // namespace edgeshade
