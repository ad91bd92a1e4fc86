#include "src/render/frame/light_methods.hpp"

#include "src/render/frame/frame.hpp"
#include "src/render/shadow_map/map_words.hpp"
#include "src/scene/build_parts.hpp"
#include "src/scene/shadow_facts.hpp"

#include <cmath>

namespace edgeshade {
namespace {

/// What a light's planes are.
[[maybe_unused]] void describePlanes(const ShadowPlanes& planes, LightMethod& method) {
    const std::size_t count = planes.all().size();
    method.why = "onto " + std::to_string(count) +
                 (count == 1 ? " plane alone, which has " : " planes alone, which have ") +
                 std::to_string(std::lround(100.0 * planes.share())) + " % of all surfaces' area";
    method.buildMs = planes.buildMs();
    method.bytes = planes.bytes();
}

void describeLookup(const GpuScene& scene, const Light& light, LightMethod& method) {
    const PrimitiveMapState* state = scene.primitiveMaps.of(light);
    if (!state) return;
    method.buildMs = state->buildMs;
    if (state->map) method.bytes = state->map->bytes();
}

} // namespace

std::vector<LightMethod> lightMethods(const GpuScene& scene, const FrameView& view,
                                      const Renderer& renderer) {
    const RenderSettings& settings = renderer.settings();
    const ShadowPolicy policy = renderer.policyFor(sceneFactsOf(scene));
    std::vector<LightMethod> methods;
    for (const FrameLight& of : view.lights) {
        const LightFacts light = lightFactsOf(of);
        const LookupFacts lookup = lookupFactsOf(scene, of.light);
        const LightChoice choice = policy.choose(light, lookup);
        LightMethod& method = methods.emplace_back();
        method.method = wordFor(choice.technique);
        method.rule = choice.rule;
        method.why = policy.reasonFor(light, lookup);
        if (choice.technique == Technique::map) {
            method.why = mapWords(of.light, settings.map);
            method.bytes = renderer.mapBytesOf(of.light);
        }
        if constexpr (hasRivals)
            if (choice.technique == Technique::planar) describePlanes(scene.planes, method);
        if (settings.looksUpPrimitives() && of.drawn && of.shadowed)
            describeLookup(scene, of.light, method);
    }
    return methods;
}

} // namespace edgeshade
