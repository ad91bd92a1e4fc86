#include "src/render/volumes/volume_renderer.hpp"

#include "src/shadow/lights/light_contact.hpp"

namespace edgeshade {

const glm::vec4& VolumeTints::of(const VolumeDraw& draw) const {
    if (draw.shape != VolumeDraw::Shape::sides) return caps;
    if (draw.times == Times::twice) return twice;
    return draw.zFail ? behind : before;
}

BatchPlan cornerRecordPlan(const GpuBatch& batch, std::size_t index, const Light& light) {
    const glm::dvec4 place = placeInObject(light, batch.worldFromBatch);
    const Geometry& geometry = *batch.geometry;
    // They tell a light's distance from a thin triangle's plane less well than planes do.
    const double reach = 4.0 * contactReachOf(geometry.positions, geometry.indices, place);
    return {.batch = index, .light = glm::vec4(place), .reach = static_cast<float>(reach)};
}

} // namespace edgeshade
