#pragma once

#include "src/render/technique/shadow_technique.hpp"

namespace edgeshade {

/// Looks up the shadows of lights at rest in their primitive maps (docs/method.md, Primitive maps),
/// which prepareScene() has made.
class LookupTechnique : public ShadowTechnique {
  public:
    const GpuPrimitiveMap* primitivesOf(const GpuScene& scene, const Light& light) const override {
        return scene.primitiveMaps.mapOf(light);
    }
    void describe(const GpuScene& scene, const Light& light, LightMethod& method) const override {
        const PrimitiveMapState* state = scene.primitiveMaps.of(light);
        if (!state) return;
        method.buildMs = state->buildMs;
        if (state->map) method.bytes = state->map->bytes();
    }
};

} // namespace edgeshade
