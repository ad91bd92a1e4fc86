#pragma once

#include "preprocess/scene/sampler.hpp"

#include <array>
#include <cstddef>
#include <glm/glm.hpp>

namespace edgeshade {

enum class AlphaMode { opaque, mask, blend };

/// How surfaces are shaded: full reflection by their materials, or base colour and Lambert's law.
enum class Shading { full, base };

/// Materials of a ground laid beneath a scene. No file has them; they receive shadow and cast none.
enum class GroundMaterial {
    none,
    surface, ///< a floor of one colour
    catcher, ///< shows only shadow, on the background, fading with vertex alpha
};

/// Surfaces that a section makes of others. No file has them.
enum class SectionPart {
    none,
    fill, ///< closes a cut of a scene that casts as a whole: it receives shadow and casts none
    away, ///< cut away from such a scene: it casts and is invisible. Opaque surfaces are BLEND
          ///< then, because the depth buffer doesn't have them.
};

/// Use of a material's texture, with the channels that glTF reads.
enum class TextureSlot {
    baseColor,         ///< RGBA, sRGB; with specular-glossiness the diffuse colour
    metallicRoughness, ///< G, B; with specular-glossiness, specular (sRGB) and glossiness in RGBA
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

/// A texture of a material and how it is sampled.
struct MaterialTexture {
    int texture = -1; ///< index in the file; -1: none
    int image = -1;   ///< the image drawn, as chosen by ImageChoice; -1: none
    Sampler sampler;
    int texcoordSet = 0;
    glm::mat3 uvTransform{1.0f}; ///< KHR_texture_transform: uv' = uvTransform * (u, v, 1)
    int channel = 0;             ///< index of the material's texture coordinates that it uses, see
                                 ///< TexcoordChannel
};

/// One of the texture coordinates of a material's vertices: a set in the file, transformed.
struct TexcoordChannel {
    int set = 0; ///< TEXCOORD_n
    glm::mat3 transform{1.0f};

    bool operator==(const TexcoordChannel&) const = default;
};
inline constexpr int mostTexcoordChannels = 4;

/// The properties of a glTF material that this program draws (glTF 2.0, 3.9, and the KHR_materials
/// extensions that docs/extensions.md lists). Factors are linear.
struct Material {
    AlphaMode alphaMode = AlphaMode::opaque;
    bool doubleSided = false; ///< visible from behind, where Scene::culls; BLEND surfaces always
                              ///< are
    GroundMaterial ground = GroundMaterial::none;
    SectionPart section = SectionPart::none;
    bool unlit = false; ///< KHR_materials_unlit: shows its colour unchanged; it casts shadow all
                        ///< the same
    float alphaCutoff = 0.5f;
    glm::vec4 baseColorFactor{1.0f};
    bool specularGlossiness = false; ///< base colour is diffuse, `specularColor` is the reflectance
    float metallic = 1.0f;           ///< 0..1
    float roughness = 1.0f;          ///< 0..1; 1 - glossiness
    float normalScale = 1.0f;
    float occlusionStrength = 1.0f;      ///< 0..1
    glm::vec3 emissive{0.0f};            ///< with KHR_materials_emissive_strength multiplied in
    float dielectricReflectance = 0.04f; ///< at normal incidence, from KHR_materials_ior
    float specular = 1.0f;               ///< 0..1
    glm::vec3 specularColor{1.0f};       ///< 0 or more
    float clearcoat = 0.0f;              ///< 0..1
    float clearcoatRoughness = 0.0f;     ///< 0..1
    float clearcoatNormalScale = 1.0f;
    float transmission = 0.0f; ///< 0..1, KHR_materials_transmission
    std::array<MaterialTexture, textureSlots> textures;
    int texcoordChannels = 1; ///< number of `channels` in use by its vertices, 1 or more
    std::array<TexcoordChannel, mostTexcoordChannels> channels; ///< the first is the base colour's

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
        if (ground != GroundMaterial::none || section == SectionPart::fill) return false;
        return castMasked || alphaMode == AlphaMode::opaque ||
               (section == SectionPart::away && alphaMode == AlphaMode::blend);
    }

    /// Whether its surfaces are drawn.
    bool isSeen() const { return section != SectionPart::away; }
    /// Whether they are drawn and show what is behind them.
    bool isSeeThrough() const { return isSeen() && alphaMode == AlphaMode::blend; }

    /// Whether base colour and Lambert's law are enough: the remaining reflection of a rough
    /// dielectric is below what the display shows.
    bool isPlain() const;
};

/// Reduces the material to what Shading::base draws.
void keepBase(Material& material);

} // namespace edgeshade
