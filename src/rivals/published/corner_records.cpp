#include "src/rivals/published/corner_records.hpp"

#include "src/shadow/lights/light_contact.hpp"

namespace edgeshade {
namespace {

BatchPlan batchPlan(const GpuBatch& batch, std::size_t index, const Light& light) {
    const glm::dvec4 place = placeInObject(light, batch.worldFromBatch);
    const Geometry& geometry = *batch.geometry;
    // Corners give a light's distance from a thin triangle's plane less precisely than planes do.
    const double reach = 4.0 * contactReachOf(geometry.positions, geometry.indices, place);
    return {.batch = index, .light = glm::vec4(place), .reach = static_cast<float>(reach)};
}

} // namespace

const ShadowBuffers& cornerRecordsOf(const BatchVolumes& volumes, VolumeLayout layout) {
    return static_cast<const ShadowBuffers&>(*volumes.recordsOf(layout));
}

void planCornerRecords(const GpuScene& scene, const CasterGroupInSlice& casters,
                       VolumeLayout layout, CountPlan& plan,
                       const std::function<void(const ShadowBuffers&, std::size_t, std::size_t,
                                                std::vector<VolumeDraw>&)>& append) {
    plan.clear();
    for (std::size_t i = 0; i < scene.batches.size(); ++i) {
        if (!casters.counts(scene.batches[i])) continue;
        plan.batches.push_back(batchPlan(scene.batches[i], i, casters.source().light));
        const BatchVolumes& volumes = scene.volumesOf(i, casters.source(), layout, casters.group);
        append(cornerRecordsOf(volumes, layout), i, plan.batches.size() - 1, plan.draws.once);
    }
}

} // namespace edgeshade
