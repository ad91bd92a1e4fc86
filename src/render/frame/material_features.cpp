#include "src/render/frame/material_features.hpp"

#include <algorithm>

namespace edgeshade {
namespace {

using enum TextureSlot;

/// A texture and its name in the shader.
struct Map {
    TextureSlot slot;
    const char* sampler;
};
constexpr Map maps[] = {
    {baseColor, "u_texture"},
    {metallicRoughness, "u_reflectanceMap"},
    {normal, "u_normalMap"},
    {occlusion, "u_occlusionMap"},
    {emissive, "u_emissiveMap"},
    {specular, "u_specularMap"},
    {specularColor, "u_specularColorMap"},
    {clearcoat, "u_clearcoatMap"},
    {clearcoatRoughness, "u_clearcoatRoughnessMap"},
    {clearcoatNormal, "u_clearcoatNormalMap"},
};
static_assert(std::size(maps) == textureSlots);

bool isNormal(TextureSlot slot) {
    return slot == normal || slot == clearcoatNormal;
}

} // namespace

bool MaterialFeatures::takes(int channel) const {
    return std::find(channels.begin(), channels.end(), channel) != channels.end();
}

MaterialFeatures featuresOf(const GpuScene& scene, const SurfaceChunk& chunk, bool ambient,
                            bool derivatives, int textureUnits) {
    const Material& material = scene.materials[chunk.material];
    MaterialFeatures features;
    features.channels.fill(-1);
    features.glossy = material.specularGlossiness;
    features.clearcoat = material.clearcoat > 0.0f;
    features.ambient = ambient;
    for (const Map& map : maps) {
        const MaterialTexture& texture = material.of(map.slot);
        const bool seen = map.slot != occlusion || ambient;
        const bool shown =
            map.slot != emissive || (ambient && material.emissive != glm::vec3(0.0f));
        const bool turned = !isNormal(map.slot) || chunk.tangents || derivatives;
        if (!scene.textures.has(texture) || !seen || !shown || !turned || textureUnits == 0)
            continue;
        features.channels[static_cast<std::size_t>(map.slot)] =
            static_cast<signed char>(texture.channel);
        --textureUnits;
    }
    features.tangents = chunk.tangents && (features.has(normal) || features.has(clearcoatNormal));
    return features;
}

void addDefines(const MaterialFeatures& features, std::vector<std::string>& defines) {
    defines.push_back("MATERIAL");
    if (features.ambient) defines.push_back("AMBIENT");
    if (features.glossy) defines.push_back("GLOSSY");
    if (features.clearcoat) defines.push_back("CLEARCOAT");
    int mapBits = 0;
    std::string sets;
    for (std::size_t slot = 0; slot < textureSlots; ++slot) {
        const int channel = features.channels[slot];
        if (channel >= 0) mapBits |= 1 << slot;
        sets += (slot == 0 ? "" : ", ") + std::to_string(std::max(channel, 0));
    }
    defines.push_back("MAPS " + std::to_string(mapBits));
    defines.push_back("MAP_SETS " + sets);
    if (features.tangents) defines.push_back("TANGENTS");
}

void setMaterial(const gl::Program& program, const MaterialFeatures& features,
                 const Material& material, const Textures& textures, int firstUnit) {
    program.set("u_baseColor", material.baseColorFactor);
    program.set("u_reflectance", glm::vec4(material.metallic, material.roughness,
                                           material.dielectricReflectance, material.specular));
    program.set("u_specularColor", material.specularColor);
    program.set("u_emissive", material.emissive);
    program.set("u_normalScale", material.normalScale);
    program.set("u_occlusionStrength", material.occlusionStrength);
    program.set("u_transmission", material.transmission);
    program.set("u_clearcoat", glm::vec3(material.clearcoat, material.clearcoatRoughness,
                                         material.clearcoatNormalScale));
    int unit = firstUnit;
    for (const Map& map : maps) {
        if (!features.has(map.slot)) continue;
        program.setTexture(map.sampler, unit++, textures.of(material.of(map.slot)));
    }
}

} // namespace edgeshade
