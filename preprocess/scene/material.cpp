#include "preprocess/scene/material.hpp"

namespace edgeshade {
namespace {

/// Roughness from which a dielectric's highlight is at most a hundredth of its scattered light.
constexpr float roughest = 0.95f;

} // namespace

bool Material::isPlain() const {
    for (std::size_t slot = 1; slot < textureSlots; ++slot)
        if (textures[slot].texture >= 0) return false;
    const bool reflects = specularGlossiness
                              ? specularColor != glm::vec3(0.0f) && roughness < roughest
                              : metallic > 0.0f || (specular > 0.0f && roughness < roughest);
    return !reflects && emissive == glm::vec3(0.0f) && clearcoat == 0.0f;
}

void keepBase(Material& material) {
    Material base;
    base.alphaMode = material.alphaMode;
    base.doubleSided = material.doubleSided;
    base.ground = material.ground;
    base.unlit = material.unlit;
    base.alphaCutoff = material.alphaCutoff;
    base.baseColorFactor = material.baseColorFactor;
    base.metallic = 0.0f;
    base.of(TextureSlot::baseColor) = material.baseColor();
    base.channels[0] = material.channels[0];
    material = base;
}

} // namespace edgeshade
