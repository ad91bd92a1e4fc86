#include "src/scene/alpha_lookup.hpp"

#include "src/scene/textures.hpp"

namespace edgeshade {

AlphaLookup alphaLookupOf(const Material& material, const Textures& textures) {
    AlphaLookup lookup;
    lookup.texture = textures.of(material.baseColor());
    lookup.factor = material.baseColorFactor.a;
    lookup.cutoff = material.alphaCutoff;
    return lookup;
}

} // namespace edgeshade
