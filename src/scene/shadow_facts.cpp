#include "src/scene/shadow_facts.hpp"

namespace edgeshade {

SceneFacts sceneFactsOf(const GpuScene& scene) {
    SceneFacts facts;
    for (const GpuBatch& batch : scene.batches) {
        if (!batch.ground) facts.triangles += batch.geometry->indices.size() / 3;
        facts.anyAnimated = facts.anyAnimated || (batch.animated && !batch.hidden);
    }
    return facts;
}

LightFacts lightFactsOf(const FrameLight& light) {
    return {.isDrawn = light.drawn,
            .isShadowed = light.shadowed,
            .rests = light.atRest,
            .hasExtent = light.light.extent.has_value(),
            .hasRange = light.light.hasRange(),
            .isSpot = light.light.isSpot()};
}

LookupFacts lookupFactsOf(const GpuScene& scene, const Light& light) {
    const PrimitiveMapState* state = scene.primitiveMaps.of(light);
    if (!state) return {};
    return {true, state->map != nullptr, state->why};
}

LookupFacts lookupFactsOf(const GpuScene& scene, const FrameLight& light) {
    LookupFacts facts = lookupFactsOf(scene, light.light);
    const GpuPrimitiveMap* map = scene.primitiveMaps.mapOf(light.light);
    facts.isUsable = map && map->extended == light.atOnce;
    return facts;
}

} // namespace edgeshade
