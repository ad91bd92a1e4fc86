#include "preprocess/reading/material_reading.hpp"

#include "preprocess/gltf/json_field.hpp"

#include <cmath>
#include <optional>

namespace edgeshade {
namespace {

/// The number as a float, for the shaders.
float finiteFloat(const JsonField& field) {
    const auto value = static_cast<float>(field.number());
    if (!std::isfinite(value)) field.fail(" has a number outside the range of floats");
    return value;
}

float floatOr(const JsonField& object, const char* key, float otherwise) {
    const auto field = object.find(key);
    return field ? finiteFloat(*field) : otherwise;
}

/// A factor, clamped to 0..1.
float shareOr(const JsonField& object, const char* key, float otherwise) {
    return glm::clamp(floatOr(object, key, otherwise), 0.0f, 1.0f);
}

template <glm::length_t N>
glm::vec<N, float> vectorOr(const JsonField& object, const char* key,
                            const glm::vec<N, float>& otherwise) {
    const auto field = object.find(key);
    if (!field) return otherwise;
    field->requireArray();
    if (field->size() != N) field->numbers(N); // reports the error
    glm::vec<N, float> vector;
    for (glm::length_t c = 0; c < N; ++c)
        vector[c] = finiteFloat(field->item(static_cast<std::size_t>(c)));
    return vector;
}

/// The matrix of KHR_texture_transform: translation * rotation * scale.
glm::mat3 uvTransformOf(const JsonField& transform) {
    const float rotation = floatOr(transform, "rotation", 0.0f);
    const auto scale = vectorOr(transform, "scale", glm::vec2(1.0f));
    const auto offset = vectorOr(transform, "offset", glm::vec2(0.0f));
    const float c = std::cos(rotation), s = std::sin(rotation);
    return {{c * scale.x, -s * scale.x, 0.0f},
            {s * scale.y, c * scale.y, 0.0f},
            {offset.x, offset.y, 1.0f}};
}

/// Reads one material.
class MaterialReader {
  public:
    MaterialReader(const JsonField& root, const JsonField& source, Warnings& warnings)
        : root_(root), source_(source), warnings_(warnings) {}

    Material read() {
        const auto mode = source_.find("alphaMode");
        const std::string alphaMode = mode ? mode->text() : "OPAQUE";
        if (alphaMode == "MASK") material_.alphaMode = AlphaMode::mask;
        if (alphaMode == "BLEND") material_.alphaMode = AlphaMode::blend;
        material_.alphaCutoff = floatOr(source_, "alphaCutoff", 0.5f);
        orLeaveOut("doubleSided is", [&] {
            const auto sides = source_.find("doubleSided");
            material_.doubleSided = sides && sides->boolean();
        });
        const auto metallic = source_.find("pbrMetallicRoughness");
        if (metallic) readBaseColor(*metallic, "baseColorFactor", "baseColorTexture");
        source_.ifExtension("KHR_materials_unlit",
                            [&](const JsonField&) { material_.unlit = true; });
        source_.ifExtension("KHR_materials_pbrSpecularGlossiness", [&](const JsonField& glossy) {
            material_.specularGlossiness = true;
            material_.of(TextureSlot::baseColor) = {};
            material_.baseColorFactor = glm::vec4(1.0f);
            readBaseColor(glossy, "diffuseFactor", "diffuseTexture");
            orLeaveOut("its highlights are", [&] { readSpecularGlossiness(glossy); });
        });
        if (metallic && !material_.specularGlossiness)
            orLeaveOut("its metalness and roughness are",
                       [&] { readMetallicRoughness(*metallic); });
        if (material_.unlit)
            keepBase(material_);
        else
            readWhatReflects();
        assignChannels();
        return material_;
    }

  private:
    /// Reads an optional part of a material; a broken part leaves no trace.
    template <class Read>
    void orLeaveOut(const std::string& what, Read read) {
        const Material before = material_;
        if (!readOrWarn(warnings_, what + " left out", read)) material_ = before;
    }

    template <class Read>
    void readExtension(const char* name, const std::string& what, Read read) {
        source_.ifExtension(name, [&](const JsonField& extension) {
            orLeaveOut(what, [&] {
                extension.requireObject();
                read(extension);
            });
        });
    }

    void readTexture(const JsonField& object, const char* key, TextureSlot slot) {
        object.ifPresent(key, [&](const JsonField& info) {
            info.requireObject();
            MaterialTexture texture;
            texture.texture = info.member("index").index();
            const auto set = info.find("texCoord");
            texture.texcoordSet = set ? set->index() : 0;
            info.ifExtension("KHR_texture_transform", [&](const JsonField& transform) {
                texture.uvTransform = uvTransformOf(transform);
                for (glm::length_t c = 0; c < 3; ++c)
                    if (!std::isfinite(glm::dot(texture.uvTransform[c], glm::vec3(1.0f))))
                        transform.fail(" has a number outside the range of floats");
                if (const auto own = transform.find("texCoord")) texture.texcoordSet = own->index();
            });
            texture.sampler = samplerOf(texture.texture);
            material_.of(slot) = texture;
        });
    }

    /// Image selection warns of a missing texture.
    Sampler samplerOf(int texture) const {
        Sampler sampler;
        const auto textures = root_.find("textures");
        if (!textures || static_cast<std::size_t>(texture) >= textures->size()) return sampler;
        const JsonField field = textures->item(static_cast<std::size_t>(texture));
        const auto index = field.find("sampler");
        if (!index) return sampler;
        const JsonField samplers = root_.member("samplers");
        const JsonField given =
            samplers.item(static_cast<std::size_t>(index->indexInto(samplers.size(), "samplers")));
        const auto take = [&](const char* key, int& value) {
            if (const auto number = given.find(key)) value = number->index();
        };
        take("wrapS", sampler.wrapS);
        take("wrapT", sampler.wrapT);
        take("minFilter", sampler.minFilter);
        take("magFilter", sampler.magFilter);
        return sampler;
    }

    void readBaseColor(const JsonField& object, const char* factor, const char* texture) {
        material_.baseColorFactor = vectorOr(object, factor, material_.baseColorFactor);
        readTexture(object, texture, TextureSlot::baseColor);
    }

    void readMetallicRoughness(const JsonField& metallic) {
        material_.metallic = shareOr(metallic, "metallicFactor", 1.0f);
        material_.roughness = shareOr(metallic, "roughnessFactor", 1.0f);
        if (material_.metallic > 0.0f || material_.roughness > 0.0f)
            readTexture(metallic, "metallicRoughnessTexture", TextureSlot::metallicRoughness);
    }

    /// Reads the archived KHR_materials_pbrSpecularGlossiness.
    void readSpecularGlossiness(const JsonField& glossy) {
        material_.metallic = 0.0f;
        material_.specularColor =
            glm::clamp(vectorOr(glossy, "specularFactor", glm::vec3(1.0f)), 0.0f, 1.0f);
        material_.roughness = 1.0f - shareOr(glossy, "glossinessFactor", 1.0f);
        readTexture(glossy, "specularGlossinessTexture", TextureSlot::metallicRoughness);
    }

    void readWhatReflects() {
        orLeaveOut("its normal map is", [&] {
            const auto info = source_.find("normalTexture");
            if (!info) return;
            material_.normalScale = floatOr(*info, "scale", 1.0f);
            if (material_.normalScale != 0.0f)
                readTexture(source_, "normalTexture", TextureSlot::normal);
        });
        orLeaveOut("its occlusion is", [&] {
            const auto info = source_.find("occlusionTexture");
            if (!info) return;
            material_.occlusionStrength = shareOr(*info, "strength", 1.0f);
            if (material_.occlusionStrength > 0.0f)
                readTexture(source_, "occlusionTexture", TextureSlot::occlusion);
        });
        orLeaveOut("its emission is", [&] { readEmission(); });
        readExtension("KHR_materials_ior", "its highlights are", [&](const JsonField& extension) {
            const float ior = floatOr(extension, "ior", 1.5f);
            if (ior != 0.0f && ior < 1.0f)
                extension.member("ior").fail(" is " + std::to_string(ior) +
                                             ", but must be 0, or 1 or more");
            // an ior of 0 reflects all, as the extension says
            const float share = (ior - 1.0f) / (ior + 1.0f);
            material_.dielectricReflectance = share * share;
        });
        if (!material_.specularGlossiness)
            readExtension("KHR_materials_specular", "its highlights are",
                          [&](const JsonField& extension) { readSpecular(extension); });
        readExtension("KHR_materials_clearcoat", "its clear coat is",
                      [&](const JsonField& extension) { readClearcoat(extension); });
        readExtension(
            "KHR_materials_transmission", "its transmission is", [&](const JsonField& extension) {
                material_.transmission = shareOr(extension, "transmissionFactor", 0.0f);
                if (material_.transmission == 0.0f || material_.alphaMode != AlphaMode::opaque)
                    return;
                material_.alphaMode = AlphaMode::blend; // it casts no shadow and doesn't refract
                material_.baseColorFactor.a = 1.0f;
            });
    }

    void readEmission() {
        material_.emissive =
            glm::max(vectorOr(source_, "emissiveFactor", glm::vec3(0.0f)), glm::vec3(0.0f));
        source_.ifExtension("KHR_materials_emissive_strength", [&](const JsonField& extension) {
            material_.emissive *= std::max(floatOr(extension, "emissiveStrength", 1.0f), 0.0f);
        });
        if (!std::isfinite(glm::dot(material_.emissive, glm::vec3(1.0f))))
            source_.member("emissiveFactor").fail(" has a number outside the range of floats");
        if (material_.emissive != glm::vec3(0.0f))
            readTexture(source_, "emissiveTexture", TextureSlot::emissive);
    }

    void readSpecular(const JsonField& extension) {
        material_.specular = shareOr(extension, "specularFactor", 1.0f);
        material_.specularColor =
            glm::max(vectorOr(extension, "specularColorFactor", glm::vec3(1.0f)), glm::vec3(0.0f));
        if (material_.specular == 0.0f) return;
        readTexture(extension, "specularTexture", TextureSlot::specular);
        readTexture(extension, "specularColorTexture", TextureSlot::specularColor);
    }

    void readClearcoat(const JsonField& extension) {
        material_.clearcoat = shareOr(extension, "clearcoatFactor", 0.0f);
        material_.clearcoatRoughness = shareOr(extension, "clearcoatRoughnessFactor", 0.0f);
        if (material_.clearcoat == 0.0f) return;
        readTexture(extension, "clearcoatTexture", TextureSlot::clearcoat);
        readTexture(extension, "clearcoatRoughnessTexture", TextureSlot::clearcoatRoughness);
        readTexture(extension, "clearcoatNormalTexture", TextureSlot::clearcoatNormal);
        if (const auto info = extension.find("clearcoatNormalTexture"))
            material_.clearcoatNormalScale = floatOr(*info, "scale", 1.0f);
    }

    /// Textures with the same set and the same transform share a channel.
    void assignChannels() {
        const auto wantedBy = [](const MaterialTexture& texture) {
            return TexcoordChannel{texture.texcoordSet, texture.uvTransform};
        };
        auto& channels = material_.channels;
        channels[0] = wantedBy(material_.baseColor());
        bool named = material_.baseColor().texture >= 0;
        for (std::size_t slot = 1; slot < textureSlots; ++slot) {
            MaterialTexture& texture = material_.textures[slot];
            if (texture.texture < 0) continue;
            const TexcoordChannel wanted = wantedBy(texture);
            if (!named) channels[0] = wanted;
            named = true;
            int channel = 0;
            while (channel < material_.texcoordChannels && channels[channel] != wanted)
                ++channel;
            if (channel == mostTexcoordChannels) {
                readOrWarn(warnings_, "a texture that needs a fifth is left out", [&] {
                    source_.fail(
                        " uses more than four combinations of texture coordinates and transforms");
                });
                texture = {};
                continue;
            }
            if (channel == material_.texcoordChannels)
                channels[material_.texcoordChannels++] = wanted;
            texture.channel = channel;
        }
    }

    const JsonField& root_;
    const JsonField& source_;
    Warnings& warnings_;
    Material material_;
};

} // namespace

std::vector<Material> readMaterials(const GltfDocument& document, Warnings& warnings) {
    std::vector<Material> materials;
    const JsonField root(document.path, document.json);
    root.ifPresent("materials", [&](const JsonField& all) {
        all.forEachItem([&](const JsonField& source) {
            materials.push_back(MaterialReader(root, source, warnings).read());
        });
    });
    materials.emplace_back();
    return materials;
}

} // namespace edgeshade
