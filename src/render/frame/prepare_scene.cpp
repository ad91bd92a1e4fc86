#include "src/render/frame/prepare_scene.hpp"

#include "src/render/shadow_map/map_words.hpp"
#include "src/scene/build_parts.hpp"
#include "src/scene/solid_surfaces.hpp"

#include <cmath>

#include <algorithm>
#include <string>

namespace edgeshade {
namespace {

/// What primitive maps are made of and for.
struct MapTask {
    std::vector<Light> lights;
    MapChoice choice;
};

bool isAutomatic(const RenderSettings& settings) {
    return settings.shadows == ShadowMethod::automatic;
}

/// `extents`: also those of lights with an extent.
MapTask mapTask(const std::vector<FrameLight>& lights, const RenderSettings& settings,
                bool restingAlone, bool extents) {
    MapTask task{{}, isAutomatic(settings) ? MapChoice::thatPay : MapChoice::all};
    for (std::size_t i = 0; i < std::min(lights.size(), mostMappedLights); ++i) {
        const FrameLight& of = lights[i];
        if (of.drawn && of.shadowed && (extents || !of.light.extent) &&
            (of.atRest || !restingAlone))
            task.lights.push_back(of.light);
    }
    return task;
}

/// Whether there are surfaces to look up that volumes can't give shadows: they are seen together
/// with what is behind them, for which the stencil counts.
bool receivesSeeThrough(const GpuScene& scene, const FrameView& view,
                        const RenderSettings& settings) {
    return settings.shadows == ShadowMethod::volumes && settings.shading == Shading::full &&
           scene.seeThrough && view.drawBlended && !view.mask;
}

/// Not where some triangles aren't seen that cast, or may have holes: they are counted by other
/// rules.
bool mayCullCasters(const LoadedScene& loaded, const FrameView& view,
                    const RenderSettings& settings) {
    const auto records = settings.records();
    return settings.casterCulling && records && records->volumes == VolumeLayout::planePairs &&
           !view.culls && !loaded.settings.castMasked;
}

const char* nameOf(ShadowMethod method) {
    switch (method) {
    case ShadowMethod::map:
        return "map";
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

void prepareScene(GpuScene& scene, const LoadedScene& loaded, const FrameView& view,
                  const RenderSettings& settings, const gl::Capabilities& capabilities) {
    if (settings.looksUpPrimitives() || receivesSeeThrough(scene, view, settings)) {
        const MapTask task =
            mapTask(view.lights, settings, settings.shadows != ShadowMethod::primitiveMap,
                    settings.shadows == ShadowMethod::primitiveMap);
        scene.primitiveMaps.make(loaded, task.lights, task.choice, settings.primitiveMap,
                                 capabilities);
    }
    if constexpr (mayCullSolids)
        if (settings.cullSolids) sortSolidsLast(scene, loaded);
    if constexpr (hasRivals)
        if (settings.shadows == ShadowMethod::planar) scene.planes.make(loaded, settings.planes);
    const auto records = settings.records();
    if (records) scene.groups.upload(loaded, view.lights, *records);
    if (mayCullCasters(loaded, view, settings))
        scene.culled.make(loaded, view.lights, records->layout,
                          capabilities.vertexHighpMantissaBits);
    else
        scene.culled.clear();
}

bool prepareSceneMeanwhile(GpuScene& scene, const LoadedScene& loaded,
                           const std::vector<FrameLight>& lights, const RenderSettings& settings,
                           const gl::Capabilities& capabilities, double milliseconds) {
    const MapTask task = mapTask(lights, settings, true, true);
    return scene.primitiveMaps.advance(loaded, task.lights, task.choice, settings.primitiveMap,
                                       capabilities, milliseconds);
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
                         : of.atRest ? "the light has an extent or is counted in groups, so no "
                                       "casters are left out"
                                     : "it moves, so no casters are left out";
        }
        if (!settings.looksUpPrimitives()) continue;
        const PrimitiveMapState* state = scene.primitiveMaps.of(of.light);
        if (state || method.why.empty())
            method.why = state ? state->why
                         : methods.size() > mostMappedLights
                             ? "only the first " + std::to_string(mostMappedLights) +
                                   " lights have primitive maps"
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
