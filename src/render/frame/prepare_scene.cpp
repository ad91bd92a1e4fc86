#include "src/render/frame/prepare_scene.hpp"

#include "src/render/shadow_map/map_words.hpp"
#include "src/scene/build_parts.hpp"
#include "src/scene/solid_surfaces.hpp"
#include "src/shadow/geometry/light_budget.hpp"
#include "src/shadow/geometry/light_range.hpp"

#include <cmath>

#include <algorithm>
#include <string>

namespace edgeshade {
namespace {

bool isAutomatic(const RenderSettings& settings) {
    return settings.shadows == ShadowMethod::automatic;
}

/// Whether a light may reach something that is see-through.
bool mayReachSeeThrough(const GpuScene& scene, const Light& light) {
    if (!light.hasRange()) return true;
    const auto isSeeThrough = [&](const SurfaceChunk& chunk) {
        return scene.materials[chunk.material].alphaMode == AlphaMode::blend;
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

/// Sorts lights by what they add to the picture, those with maps taken twice: a map is built in
/// many frames' time, and would go with the next turn of the camera.
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

/// `extents`: also those of lights with an extent. `seeThroughAlone`: volumes are counted for what
/// casts.
MapDemand demandOf(const GpuScene& scene, const FrameView& view, const RenderSettings& settings,
                   bool restingAlone, bool extents, bool seeThroughAlone = false) {
    MapDemand demand;
    demand.choice = isAutomatic(settings) ? MapChoice::thatPay : MapChoice::all;
    demand.castersReceive = !seeThroughAlone;
    std::vector<Light> others;
    for (const FrameLight& of : view.lights) {
        if ((of.light.extent && !extents) || (restingAlone && !of.atRest)) continue;
        const bool wanted =
            of.drawn && of.shadowed && !(seeThroughAlone && !mayReachSeeThrough(scene, of.light));
        (wanted ? demand.lights : others).push_back(of.light);
    }
    if constexpr (weighsLights) sortByImportance(view, scene.primitiveMaps, demand.lights);
    demand.wanted = demand.lights.size();
    demand.lights.insert(demand.lights.end(), others.begin(), others.end());
    return demand;
}

/// Whether there are surfaces to look up that volumes can't give shadows: they are seen together
/// with what is behind them, for which the stencil counts.
bool receivesSeeThrough(const GpuScene& scene, const FrameView& view,
                        const RenderSettings& settings) {
    return settings.shadows == ShadowMethod::volumes && settings.shading == Shading::full &&
           scene.seeThrough && view.drawBlended && !view.mask;
}

const char* nameOf(ShadowMethod method) {
    switch (method) {
    case ShadowMethod::map:
        return "map";
    case ShadowMethod::irregularZBuffer:
        return readsDepth ? "irregular-z-buffer" : "";
    case ShadowMethod::planar:
        return "planar";
    case ShadowMethod::none:
        return "none";
    default:
        return "volumes";
    }
}

/// What a light's planes are.
[[maybe_unused]] void describePlanes(const ShadowPlanes& planes, LightMethod& method) {
    const std::size_t count = planes.all().size();
    method.why = "onto " + std::to_string(count) +
                 (count == 1 ? " plane alone, which has " : " planes alone, which have ") +
                 std::to_string(std::lround(100.0 * planes.share())) + " % of all surfaces' area";
    method.buildMs = planes.buildMs();
    method.bytes = planes.bytes();
}

} // namespace

// What isn't seen and casts, or may have holes, is counted by other rules.
bool mayCullCasters(const LoadedScene& loaded, const FrameView& view,
                    const RenderSettings& settings) {
    const auto records = settings.records();
    return settings.casterCulling && records && records->volumes == VolumeLayout::planePairs &&
           !view.culls && !loaded.settings.castMasked;
}

void prepareScene(GpuScene& scene, const LoadedScene& loaded, const FrameView& view,
                  const RenderSettings& settings, const gl::Capabilities& capabilities) {
    if (settings.looksUpPrimitives() || receivesSeeThrough(scene, view, settings)) {
        const bool all = settings.shadows == ShadowMethod::primitiveMap;
        const MapDemand demand =
            demandOf(scene, view, settings, !all, all, !settings.looksUpPrimitives());
        scene.primitiveMaps.make(loaded, demand, settings.primitiveMap, capabilities);
    }
    if constexpr (mayCullSolids)
        if (settings.cullSolids) sortSolidsLast(scene, loaded);
    if constexpr (hasRivals)
        if (settings.shadows == ShadowMethod::planar) scene.planes.make(loaded, settings.planes);
    const auto records = settings.records();
    if (records) scene.groups.upload(loaded, view.lights, *records);
    if (mayCullCasters(loaded, view, settings))
        scene.culled.make(loaded, view.lights,
                          {records->layout, capabilities.vertexHighpMantissaBits});
    else
        scene.culled.clear();
}

bool prepareSceneMeanwhile(GpuScene& scene, const LoadedScene& loaded, const FrameView& view,
                           const RenderSettings& settings, const gl::Capabilities& capabilities,
                           double milliseconds) {
    const MapDemand demand = demandOf(scene, view, settings, true, true);
    return scene.primitiveMaps.advance(loaded, demand, settings.primitiveMap, capabilities,
                                       milliseconds);
}

bool cullCastersMeanwhile(GpuScene& scene, const LoadedScene& loaded, const FrameView& view,
                          const RenderSettings& settings, const gl::Capabilities& capabilities) {
    if (mayCullCasters(loaded, view, settings))
        return scene.culled.advance(
            loaded, view.lights,
            {settings.records()->layout, capabilities.vertexHighpMantissaBits});
    scene.culled.clear();
    return false;
}

const GpuPrimitiveMap* extendedMapOf(const GpuScene& scene, const Light& light) {
    const PrimitiveMapState* state = scene.primitiveMaps.of(light);
    return state && state->map && state->map->extended ? state->map.get() : nullptr;
}

std::vector<LightMethod> lightMethods(const GpuScene& scene, const FrameView& view,
                                      const RenderSettings& settings) {
    std::vector<LightMethod> methods;
    for (const FrameLight& of : view.lights) {
        LightMethod& method = methods.emplace_back();
        method.method = nameOf(settings.shadows);
        if (!of.drawn || !of.shadowed) {
            method.method = "none";
            method.why = of.shadowed ? "it reaches nothing that is visible"
                                     : "others are estimated to add more to the picture";
            continue;
        }
        if (settings.shadows == ShadowMethod::map) method.why = mapWords(of.light, settings.map);
        if constexpr (hasRivals)
            if (settings.shadows == ShadowMethod::planar) describePlanes(scene.planes, method);
        if (const CulledCasters::Kept* kept = scene.culled.of(of)) {
            method.why = std::to_string(kept->gone) + " of " + std::to_string(kept->casters) +
                         " casting triangles are left out, wholly in the shadow of others";
            method.buildMs = kept->buildMs;
            method.bytes = scene.culled.sideBytes() + scene.culled.capBytes();
        } else if (settings.casterCulling) {
            method.why = view.culls         ? "the scene culls, so no casters are left out"
                         : scene.castMasked ? "casters have holes, so none are left out"
                         : !CulledCasters::suits(of)
                             ? "the light has an extent or is counted in groups, so no casters are "
                               "left out"
                         : of.atRest ? "casters that may be left out are not found yet"
                                     : "it moves, so no casters are left out";
        }
        if (!settings.looksUpPrimitives()) continue;
        const PrimitiveMapState* state = scene.primitiveMaps.of(of.light);
        if (state || method.why.empty())
            method.why = state             ? state->why
                         : of.light.extent ? "it has an extent"
                         : of.atRest       ? "its primitive map is not built"
                                           : "it moves";
        if (!state) continue;
        method.buildMs = state->buildMs;
        if (!state->map) continue;
        method.method = "primitive-map";
        method.bytes = state->map->bytes();
    }
    return methods;
}

} // namespace edgeshade
