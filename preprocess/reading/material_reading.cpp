#include "preprocess/reading/material_reading.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/gltf/tinygltf_model.hpp"

#include <cmath>

namespace edgeshade {
namespace {

double numberOr(const tinygltf::Value& object, const std::string& key, double otherwise) {
    if (!object.IsObject() || !object.Has(key)) return otherwise;
    return object.Get(key).IsNumber() ? object.Get(key).GetNumberAsDouble() : otherwise;
}

double elementOr(const tinygltf::Value& object, const std::string& key, std::size_t element,
                 double otherwise) {
    if (!object.IsObject() || !object.Has(key)) return otherwise;
    const tinygltf::Value& array = object.Get(key);
    if (!array.IsArray() || element >= array.ArrayLen()) return otherwise;
    const tinygltf::Value& value = array.Get(static_cast<int>(element));
    return value.IsNumber() ? value.GetNumberAsDouble() : otherwise;
}

/// KHR_texture_transform's matrix: translation * rotation * scale.
glm::mat3 uvTransformOf(const tinygltf::Value& transform) {
    const auto rotation = static_cast<float>(numberOr(transform, "rotation", 0.0));
    const auto scaleU = static_cast<float>(elementOr(transform, "scale", 0, 1.0));
    const auto scaleV = static_cast<float>(elementOr(transform, "scale", 1, 1.0));
    const auto offsetU = static_cast<float>(elementOr(transform, "offset", 0, 0.0));
    const auto offsetV = static_cast<float>(elementOr(transform, "offset", 1, 0.0));
    const float c = std::cos(rotation), s = std::sin(rotation);
    return {
        {c * scaleU, -s * scaleU, 0.0f}, {s * scaleV, c * scaleV, 0.0f}, {offsetU, offsetV, 1.0f}};
}

Sampler samplerOf(const tinygltf::Sampler& given) {
    Sampler sampler;
    sampler.wrapS = given.wrapS;
    sampler.wrapT = given.wrapT;
    if (given.minFilter >= 0) sampler.minFilter = given.minFilter;
    if (given.magFilter >= 0) sampler.magFilter = given.magFilter;
    return sampler;
}

void setTexture(const GltfDocument& document, Material& material, int texture, int texcoordSet,
                const tinygltf::Value* transform) {
    if (texture < 0) return;
    material.texture = texture;
    material.texcoordSet = texcoordSet;
    const auto& textures = document.model->textures;
    const bool exists = static_cast<std::size_t>(texture) < textures.size();
    if (exists && textures[texture].sampler >= 0)
        material.sampler = samplerOf(document.model->samplers[textures[texture].sampler]);
    if (!transform) return;
    material.uvTransform = uvTransformOf(*transform);
    material.texcoordSet = static_cast<int>(numberOr(*transform, "texCoord", texcoordSet));
}

const tinygltf::Value* textureTransform(const tinygltf::ExtensionMap& extensions) {
    const auto found = extensions.find("KHR_texture_transform");
    return found == extensions.end() ? nullptr : &found->second;
}

/// The same of a texture that tinygltf does not know.
const tinygltf::Value* textureTransform(const tinygltf::Value& info) {
    if (!info.Has("extensions")) return nullptr;
    const tinygltf::Value& extensions = info.Get("extensions");
    return extensions.Has("KHR_texture_transform") ? &extensions.Get("KHR_texture_transform")
                                                   : nullptr;
}

void readMetallicRoughness(const GltfDocument& document, const tinygltf::Material& source,
                           Material& material) {
    const auto& factor = source.pbrMetallicRoughness.baseColorFactor;
    for (glm::length_t c = 0; c < 4 && static_cast<std::size_t>(c) < factor.size(); ++c)
        material.baseColorFactor[c] = static_cast<float>(factor[c]);
    const tinygltf::TextureInfo& info = source.pbrMetallicRoughness.baseColorTexture;
    setTexture(document, material, info.index, info.texCoord, textureTransform(info.extensions));
}

/// The archived KHR_materials_pbrSpecularGlossiness: its diffuse colour stands for ours.
void readSpecularGlossiness(const GltfDocument& document, const tinygltf::Value& extension,
                            Material& material) {
    for (glm::length_t c = 0; c < 4; ++c)
        material.baseColorFactor[c] =
            static_cast<float>(elementOr(extension, "diffuseFactor", c, 1.0));
    if (!extension.Has("diffuseTexture")) return;
    const tinygltf::Value& info = extension.Get("diffuseTexture");
    setTexture(document, material, static_cast<int>(numberOr(info, "index", -1.0)),
               static_cast<int>(numberOr(info, "texCoord", 0.0)), textureTransform(info));
}

/// Numbers that doubles hold and floats do not must not reach the shaders.
void requireFinite(const GltfDocument& document, const Material& material,
                   const std::string& field) {
    bool finite = std::isfinite(material.alphaCutoff);
    for (glm::length_t c = 0; c < 4; ++c)
        finite = finite && std::isfinite(material.baseColorFactor[c]);
    for (glm::length_t c = 0; c < 3; ++c)
        finite = finite && std::isfinite(glm::dot(material.uvTransform[c], glm::vec3(1.0f)));
    if (!finite)
        throw InputError(document.where(field) + " has a number past the range of floats.");
}

Material readMaterial(const GltfDocument& document, std::size_t index) {
    const tinygltf::Material& source = document.model->materials[index];
    const std::string field = "materials[" + std::to_string(index) + "]";
    Material material;
    if (source.alphaMode == "MASK") material.alphaMode = AlphaMode::mask;
    if (source.alphaMode == "BLEND") material.alphaMode = AlphaMode::blend;
    material.alphaCutoff = static_cast<float>(source.alphaCutoff);
    material.unlit = source.extensions.contains("KHR_materials_unlit");
    readMetallicRoughness(document, source, material);
    const auto glossy = source.extensions.find("KHR_materials_pbrSpecularGlossiness");
    if (glossy != source.extensions.end())
        readSpecularGlossiness(document, glossy->second, material);
    requireFinite(document, material, field);
    return material;
}

} // namespace

std::vector<Material> readMaterials(const GltfDocument& document) {
    std::vector<Material> materials;
    for (std::size_t i = 0; i < document.model->materials.size(); ++i)
        materials.push_back(readMaterial(document, i));
    materials.emplace_back();
    return materials;
}

} // namespace edgeshade
