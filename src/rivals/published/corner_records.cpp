#include "src/rivals/published/corner_records.hpp"

#include "src/scene/gpu_scene.hpp"
#include "src/shadow/lights/light_contact.hpp"

namespace edgeshade {

BatchPlan cornerRecordPlan(const GpuBatch& batch, std::size_t index, const Light& light) {
    const glm::dvec4 place = placeInObject(light, batch.worldFromBatch);
    const Geometry& geometry = *batch.geometry;
    // Corners give a light's distance from a thin triangle's plane less precisely than planes do.
    const double reach = 4.0 * contactReachOf(geometry.positions, geometry.indices, place);
    return {.batch = index, .light = glm::vec4(place), .reach = static_cast<float>(reach)};
}

} // namespace edgeshade
