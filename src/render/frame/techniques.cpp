#include "src/render/frame/techniques.hpp"

#include "preprocess/base/error.hpp"
#include "src/render/frame/volume_renderers.hpp"
#include "src/render/irregular/points_technique.hpp"
#include "src/render/lookup/lookup_technique.hpp"
#include "src/scene/scene_facts.hpp"
#include "src/settings/build_parts.hpp"

namespace edgeshade {
namespace {

std::unique_ptr<ShadowMapPass> makeMapPass(const RenderSettings& settings,
                                           const gl::Capabilities& capabilities) {
    if (settings.map.isPlain()) return std::make_unique<ShadowMapPass>(settings.map, capabilities);
    if (settings.rivals)
        if (auto pass = settings.rivals->maps(settings, capabilities)) return pass;
    throw Error(
        ExitStatus::unavailable,
        "This build has only cube, single and cascaded shadow maps, without filters or warps.");
}

} // namespace

Techniques::Techniques(const RenderSettings& settings, const gl::Capabilities& capabilities) {
    const auto at = [&](Technique technique) -> std::unique_ptr<ShadowTechnique>& {
        return all_[static_cast<std::size_t>(technique)];
    };
    if (auto volumes = makeVolumeRenderer(settings, capabilities))
        at(Technique::volumes) =
            std::make_unique<VolumesTechnique>(std::move(volumes), settings, capabilities);
    if (settings.looksUpPrimitives()) at(Technique::lookup) = std::make_unique<LookupTechnique>();
    if (settings.shadows == ShadowMethod::map)
        at(Technique::map) = std::make_unique<MapTechnique>(makeMapPass(settings, capabilities));
    if (settings.shadows == ShadowMethod::planar) {
        if (!settings.rivals)
            throw Error(ExitStatus::unavailable, "This build has no planar shadows.");
        at(Technique::planar) = settings.rivals->planar(settings);
    }
    const ShadowPolicy policy(settings.policy(), deviceFactsOf(capabilities), {});
    if (settings.shadows == ShadowMethod::irregularZBuffer && !policy.mayAskPoints())
        throw Error(
            ExitStatus::unavailable,
            "'--shadows irregular-z-buffer' needs a GL that draws on the processor, with one "
            "sample per pixel and framebuffers with depth (GL_OES_packed_depth_stencil); "
            "'--shadows volumes' works without these.");
    if constexpr (hasPoints)
        if (policy.mayAskPoints())
            at(Technique::points) = std::make_unique<PointsTechnique>(capabilities);
}

} // namespace edgeshade
