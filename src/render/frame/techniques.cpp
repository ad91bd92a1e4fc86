#include "src/render/frame/techniques.hpp"

#include "preprocess/base/error.hpp"
#include "src/render/frame/volume_renderers.hpp"
#include "src/render/irregular/points_technique.hpp"
#include "src/render/lookup/lookup_technique.hpp"
#include "src/render/planar/planar_technique.hpp"
#include "src/scene/build_parts.hpp"
#include "src/scene/scene_facts.hpp"

namespace edgeshade {

Techniques::Techniques(const RenderSettings& settings, const gl::Capabilities& capabilities) {
    const auto at = [&](Technique technique) -> std::unique_ptr<ShadowTechnique>& {
        return all_[static_cast<std::size_t>(technique)];
    };
    if (auto volumes = makeVolumeRenderer(settings, capabilities))
        at(Technique::volumes) =
            std::make_unique<VolumesTechnique>(std::move(volumes), settings, capabilities);
    if (settings.looksUpPrimitives()) at(Technique::lookup) = std::make_unique<LookupTechnique>();
    if (settings.shadows == ShadowMethod::map)
        at(Technique::map) = std::make_unique<MapTechnique>(settings.map, capabilities);
    if (settings.shadows == ShadowMethod::planar) {
        if constexpr (hasRivals)
            at(Technique::planar) = std::make_unique<PlanarTechnique>();
        else
            throw Error(ExitStatus::unavailable, "This build has no planar shadows.");
    }
    const ShadowPolicy policy(settings.policy(), deviceFactsOf(capabilities), {});
    if (settings.shadows == ShadowMethod::irregularZBuffer && !policy.mayAskPoints())
        throw Error(ExitStatus::unavailable,
                    "'--shadows irregular-z-buffer' needs a GL whose processor draws, with one "
                    "sample a pixel and framebuffers with depth (GL_OES_packed_depth_stencil); "
                    "'--shadows volumes' does without.");
    if constexpr (hasPoints)
        if (policy.mayAskPoints())
            at(Technique::points) = std::make_unique<PointsTechnique>(capabilities);
}

} // namespace edgeshade
