#include "src/render/frame/volume_renderers.hpp"

#include "preprocess/base/error.hpp"
#include "src/render/volumes/brute_force/triangle_volumes.hpp"
#include "src/render/volumes/plane_pair_volumes.hpp"
#include "src/render/volumes/published/opposite_vertex_volumes.hpp"
#include "src/scene/build_parts.hpp"

namespace edgeshade {

std::unique_ptr<VolumeRenderer> makeVolumeRenderer(const RenderSettings& settings,
                                                   const gl::Capabilities& capabilities,
                                                   std::optional<VolumeTints> tints) {
    if (settings.layout != SidesLayout::notInstanced && !capabilities.instancing)
        throw Error(ExitStatus::unavailable,
                    "This GL has no instanced drawing; '--instancing off' does without.");
    const auto records = settings.records();
    if (!records) return nullptr;
    if (records->volumes == VolumeLayout::oppositeVertices)
        return std::make_unique<OppositeVertexVolumes>(settings.multiplicity, settings.layout,
                                                       capabilities.instancing, tints);
    if (records->volumes == VolumeLayout::triangles) {
        if constexpr (hasRivals)
            return std::make_unique<TriangleVolumes>(settings.count, settings.layout,
                                                     capabilities.instancing, tints);
        throw Error(ExitStatus::unavailable, "This build has no brute-force volumes.");
    }
    return std::make_unique<PlanePairVolumes>(settings, capabilities, tints);
}

} // namespace edgeshade
