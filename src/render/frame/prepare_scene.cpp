#include "src/render/frame/prepare_scene.hpp"

#include "src/scene/shadow_facts.hpp"
#include "src/settings/build_parts.hpp"
#include "src/shadow/layers/layer_search.hpp"
#include "src/shadow/lights/light_range.hpp"
#include "src/shadow/view/light_budget.hpp"

#include <algorithm>

namespace edgeshade {
namespace {

/// Whether a light may reach a see-through surface.
bool mayReachSeeThrough(const GpuScene& scene, const Light& light) {
    if (!light.hasRange()) return true;
    const auto isSeeThrough = [&](const SurfaceChunk& chunk) {
        return scene.materials[chunk.material].isSeeThrough();
    };
    for (const GpuBatch& batch : scene.batches) {
        const auto& chunks = *batch.surfaces;
        if (std::none_of(chunks.begin(), chunks.end(), isSeeThrough)) continue;
        const glm::dvec3 at(glm::inverse(batch.worldFromBatch) * light.position);
        const double range = rangeInObject(light, batch.worldFromBatch);
        if (std::any_of(chunks.begin(), chunks.end(), [&](const SurfaceChunk& chunk) {
                return isSeeThrough(chunk) && !isBeyond(chunk.bounds, at, range);
            }))
            return true;
    }
    return false;
}

/// Sorts lights by their effect on the picture. Lights that have a map count twice: building one
/// takes many frames, and the next turn of the camera should not discard it.
[[maybe_unused]] void sortByImportance(const FrameView& view, const PrimitiveMaps& kept,
                                       std::vector<Light>& lights) {
    std::vector<std::pair<double, Light>> weighed;
    for (const Light& light : lights) {
        const PrimitiveMapState* state = kept.of(light);
        weighed.emplace_back(importanceOf(view, light) * (state && state->map ? 2.0 : 1.0), light);
    }
    std::stable_sort(weighed.begin(), weighed.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    std::transform(weighed.begin(), weighed.end(), lights.begin(),
                   [](const auto& of) { return of.second; });
}

/// Whether any see-through surfaces receive shadows, which only lookups can give them: the stencil
/// counts for the surface behind them.
bool receivesSeeThrough(const GpuScene& scene, const RenderSettings& settings) {
    return settings.shading == Shading::full && scene.seeThrough;
}

MapDemand demandOf(const ShadowPolicy& policy, const GpuScene& scene, const FrameView& view) {
    const bool forSeeThrough = !policy.settings().asksForLookups();
    MapDemand demand{.policy = policy};
    demand.castersReceive = !forSeeThrough;
    std::vector<Light> others;
    for (const FrameLight& of : view.lights) {
        LightFacts light = lightFactsOf(of);
        if (forSeeThrough) light.reachesSeeThrough = mayReachSeeThrough(scene, of.light);
        const LookupWish wish = policy.lookupWish(light);
        if (wish.isWanted)
            demand.lights.push_back(of.light);
        else if (wish.isKept)
            others.push_back(of.light);
    }
    if constexpr (weighsLights) sortByImportance(view, scene.primitiveMaps, demand.lights);
    demand.wanted = demand.lights.size();
    demand.lights.insert(demand.lights.end(), others.begin(), others.end());
    return demand;
}

} // namespace

void makeLookups(GpuScene& scene, const LoadedScene& loaded, const FrameView& view,
                 const Renderer& renderer) {
    const RenderSettings& settings = renderer.settings();
    const gl::Capabilities& capabilities = renderer.capabilities();
    PolicySettings asked = settings.policy();
    asked.seeThroughReceives =
        receivesSeeThrough(scene, settings) && view.drawBlended && !view.mask;
    if (!asked.usesLookups()) return;
    const ShadowPolicy policy(asked, deviceFactsOf(capabilities), sceneFactsOf(loaded));
    scene.primitiveMaps.make(loaded, demandOf(policy, scene, view), settings.primitiveMap,
                             capabilities);
}

void boundCountedLayers(FrameView& view, const LoadedScene& loaded, const GpuScene& scene,
                        const ShadowPolicy& policy, bool pointsAreLights) {
    LayerSearch search;
    for (FrameLight& of : view.lights) {
        const bool alone = pointsAreLights && !of.points.empty();
        const LightChoice choice =
            policy.choose(lightFactsOf(of), alone ? LookupFacts{} : lookupFactsOf(scene, of.light));
        if (choice.counted == Technique::volumes)
            of.layers = search.bound(loaded.layerCasters(), of.counted(), stencilLimit);
    }
}

void prepareScene(GpuScene& scene, const LoadedScene& loaded, const FrameView& view,
                  const Renderer& renderer) {
    makeLookups(scene, loaded, view, renderer);
    renderer.techniques().prepareScene(scene, loaded);
    const auto records = renderer.settings().records();
    if (records) scene.groups.upload(loaded, view.lights, *records);
}

ShadowPolicy backgroundPolicy(const GpuScene& scene, const LoadedScene& loaded,
                              const RenderSettings& settings,
                              const gl::Capabilities& capabilities) {
    PolicySettings asked = settings.policy();
    asked.seeThroughReceives = receivesSeeThrough(scene, settings);
    asked.inBackground = true;
    return {asked, deviceFactsOf(capabilities), sceneFactsOf(loaded)};
}

bool prepareSceneMeanwhile(GpuScene& scene, const LoadedScene& loaded, const FrameView& view,
                           const ShadowPolicy& policy, const PrimitiveMapSettings& settings,
                           const gl::Capabilities& capabilities, double milliseconds) {
    return scene.primitiveMaps.advance(loaded, demandOf(policy, scene, view), settings,
                                       capabilities, milliseconds);
}

const GpuPrimitiveMap* extendedMapOf(const GpuScene& scene, const Light& light) {
    const GpuPrimitiveMap* map = scene.primitiveMaps.mapOf(light);
    return map && map->extended ? map : nullptr;
}

} // namespace edgeshade
