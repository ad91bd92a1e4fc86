#pragma once

#include "src/render/technique/shadow_technique.hpp"

namespace edgeshade {

/// Lights at rest are looked up in their primitive maps (docs/method.md, Looked up), which
/// prepareScene() has made.
class LookupTechnique : public ShadowTechnique {
  public:
    const GpuPrimitiveMap* primitivesOf(const GpuScene& scene, const Light& light) const override {
        const PrimitiveMapState* state = scene.primitiveMaps.of(light);
        return state ? state->map.get() : nullptr;
    }
};

} // namespace edgeshade
