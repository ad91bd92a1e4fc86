#pragma once

#include "preprocess/scene/sampler.hpp"

#include <array>
#include <cstddef>
#include <glm/glm.hpp>

namespace edgeshade {

enum class AlphaMode { opaque, mask, blend };

/// What surfaces are drawn with: all that their materials say of reflection, or base colour and
/// Lambert's law.
enum class Shading { full, base };

/// Materials of the ground that is laid beneath a scene, which no file has: they receive shadow and
/// cast none.
enum class GroundMaterial {
    none,
    surface, ///< a floor of some colour
    catcher, ///< shows shadow on the background and nothing else, the less the smaller vertex alpha
             ///< is
};

/// What a texture says of a surface, by the channels that glTF reads.
enum class TextureSlot {
    baseColor,         ///< RGBA, sRGB; of specular-glossiness the diffuse colour
    metallicRoughness, ///< G, B; of specular-glossiness specular (sRGB) and glossiness in RGBA
    normal,
    occlusion,          ///< R
    emissive,           ///< RGB, sRGB
    specular,           ///< A
    specularColor,      ///< RGB, sRGB
    clearcoat,          ///< R
    clearcoatRoughness, ///< G
    clearcoatNormal,
};
inline constexpr std::size_t textureSlots = 10;

/// A texture of a material and how it is looked up.
struct MaterialTexture {
    int texture = -1; ///< as the file says; -1: none
    int image = -1;   ///< that is drawn of it, as ImageChoice decides; -1: none
    Sampler sampler;
    int texcoordSet = 0;
    glm::mat3 uvTransform{1.0f}; ///< KHR_texture_transform: uv' = uvTransform * (u, v, 1)
    int channel = 0; ///< which of the material's texture coordinates it takes, see TexcoordChannel
};

/// One of the texture coordinates that a material's vertices have: a set of the file's,
/// transformed.
struct TexcoordChannel {
    int set = 0; ///< TEXCOORD_n
    glm::mat3 transform{1.0f};

    bool operator==(const TexcoordChannel&) const = default;
};
inline constexpr int mostTexcoordChannels = 4;

/// What of a glTF material this program draws (glTF 2.0, 3.9, and the KHR_materials extensions that
/// docs/extensions.md lists). Factors are linear.
struct Material {
    AlphaMode alphaMode = AlphaMode::opaque;
    bool doubleSided = false; ///< seen from behind, where Scene::culls; BLEND surfaces at any rate
    GroundMaterial ground = GroundMaterial::none;
    bool unlit = false; ///< KHR_materials_unlit: its colour as it is; it casts all the same
    float alphaCutoff = 0.5f;
    glm::vec4 baseColorFactor{1.0f};
    bool specularGlossiness = false; ///< base colour is diffuse, `specularColor` the reflectance
    float metallic = 1.0f;           ///< 0..1
    float roughness = 1.0f;          ///< 0..1; 1 - glossiness
    float normalScale = 1.0f;
    float occlusionStrength = 1.0f;      ///< 0..1
    glm::vec3 emissive{0.0f};            ///< times KHR_materials_emissive_strength
    float dielectricReflectance = 0.04f; ///< at normal incidence, as KHR_materials_ior has it
    float specular = 1.0f;               ///< 0..1
    glm::vec3 specularColor{1.0f};       ///< 0 and more
    float clearcoat = 0.0f;              ///< 0..1
    float clearcoatRoughness = 0.0f;     ///< 0..1
    float clearcoatNormalScale = 1.0f;
    float transmission = 0.0f; ///< 0..1, KHR_materials_transmission
    std::array<MaterialTexture, textureSlots> textures;
    int texcoordChannels = 1; ///< how many of `channels` its vertices have, 1 or more
    std::array<TexcoordChannel, mostTexcoordChannels> channels; ///< 0: the base colour's

    MaterialTexture& of(TextureSlot slot) { return textures[static_cast<std::size_t>(slot)]; }
    const MaterialTexture& of(TextureSlot slot) const {
        return textures[static_cast<std::size_t>(slot)];
    }
    const MaterialTexture& baseColor() const { return of(TextureSlot::baseColor); }
    bool hasTexture(TextureSlot slot) const { return of(slot).texture >= 0; }

    bool hasNormalTexture() const {
        return hasTexture(TextureSlot::normal) || hasTexture(TextureSlot::clearcoatNormal);
    }

    /// Whether its surfaces cast shadow. `castMasked` as in CasterSettings.
    bool casts(bool castMasked) const {
        return ground == GroundMaterial::none && (castMasked || alphaMode == AlphaMode::opaque);
    }

    /// Whether it only scatters light, as base colour and Lambert's law have it: what a rough
    /// dielectric reflects besides is less than the display shows.
    bool isPlain() const;
};

/// Leaves of the material what Shading::base draws.
void keepBase(Material& material);

} // namespace edgeshade
