#include "src/render/frame/volume_renderers.hpp"

#include "preprocess/base/error.hpp"
#include "src/render/volumes/plane_pair_volumes.hpp"

namespace edgeshade {

std::unique_ptr<VolumeRenderer> makeVolumeRenderer(const RenderSettings& settings,
                                                   const gl::Capabilities& capabilities,
                                                   std::optional<VolumeTints> tints) {
    if (settings.layout != SidesLayout::notInstanced && !capabilities.instancing)
        throw Error(ExitStatus::unavailable,
                    "This GL has no instanced drawing; '--instancing off' works without it.");
    const auto records = settings.records();
    if (!records) return nullptr;
    if (records->volumes == VolumeLayout::planePairs)
        return std::make_unique<PlanePairVolumes>(settings, capabilities, tints);
    if (settings.rivals)
        if (auto volumes = settings.rivals->volumes(settings, capabilities, tints)) return volumes;
    throw Error(ExitStatus::unavailable,
                "This build draws shadow volumes from plane-pair records only.");
}

} // namespace edgeshade
