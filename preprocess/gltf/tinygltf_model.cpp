#include "preprocess/gltf/tinygltf_model.hpp"

#include "preprocess/base/error.hpp"

#include <functional>
#include <initializer_list>

namespace edgeshade {
namespace {

using Json = nlohmann::ordered_json;

/// Items given a placeholder that the asset lacks.
struct StandIns {
    std::vector<std::size_t> accessors; ///< given a bufferView
    std::vector<std::size_t> skins;     ///< given inverseBindMatrices
};

/// The object's members of these names; empty if it is no object.
Json only(const Json& object, std::initializer_list<const char*> keys) {
    Json kept = Json::object();
    if (!object.is_object()) return kept;
    for (const char* key : keys)
        if (const auto member = object.find(key); member != object.end()) kept[key] = *member;
    return kept;
}

/// Replaces the member, if it exists, by the result of `keep` for it.
void keepOf(Json& object, const char* key, const std::function<Json(const Json&)>& keep) {
    if (const auto member = object.find(key); member != object.end()) *member = keep(*member);
}

/// An array of the results of `keep` for each item.
Json kept(const Json& items, const std::function<Json(const Json&)>& keep) {
    Json all = Json::array();
    for (const Json& item : items)
        all.push_back(keep(item));
    return all;
}

Json keptTextureInfo(const Json& source) {
    Json info = only(source, {"index", "texCoord", "extensions"});
    keepOf(info, "extensions",
           [](const Json& extensions) { return only(extensions, {"KHR_texture_transform"}); });
    return info;
}

Json keptMaterial(const Json& source) {
    Json material =
        only(source, {"alphaMode", "alphaCutoff", "pbrMetallicRoughness", "extensions"});
    keepOf(material, "pbrMetallicRoughness", [](const Json& metallic) {
        Json color = only(metallic, {"baseColorFactor", "baseColorTexture"});
        keepOf(color, "baseColorTexture", keptTextureInfo);
        return color;
    });
    keepOf(material, "extensions", [](const Json& extensions) {
        return only(extensions, {"KHR_materials_pbrSpecularGlossiness", "KHR_materials_unlit"});
    });
    return material;
}

Json keptMesh(const Json& source) {
    Json mesh = only(source, {"primitives", "weights"});
    keepOf(mesh, "primitives", [](const Json& primitives) {
        return kept(primitives, [](const Json& primitive) {
            Json triangles = only(
                primitive, {"attributes", "indices", "material", "mode", "targets", "extensions"});
            keepOf(triangles, "extensions", [](const Json& extensions) {
                return only(extensions, {"KHR_draco_mesh_compression"});
            });
            return triangles;
        });
    });
    return mesh;
}

/// Adds placeholder views: tinygltf requires one for every index accessor, and
/// KHR_draco_mesh_compression has none.
Json keptAccessors(const Json& source, std::vector<std::size_t>& standIns) {
    Json accessors = kept(source, [](const Json& accessor) {
        return only(accessor, {"bufferView", "byteOffset", "componentType", "count", "normalized",
                               "sparse", "type"});
    });
    for (std::size_t i = 0; i < accessors.size(); ++i) {
        if (accessors[i].contains("bufferView")) continue;
        accessors[i]["bufferView"] = 0;
        standIns.push_back(i);
    }
    return accessors;
}

/// Adds placeholder inverse bind matrices: tinygltf requires them, and a skin without them uses
/// identities.
Json keptSkins(const Json& source, std::vector<std::size_t>& standIns) {
    Json skins = kept(source, [](const Json& skin) {
        return only(skin, {"joints", "inverseBindMatrices"});
    });
    for (std::size_t i = 0; i < skins.size(); ++i) {
        if (skins[i].contains("inverseBindMatrices")) continue;
        skins[i]["inverseBindMatrices"] = 0;
        standIns.push_back(i);
    }
    return skins;
}

/// Keeps channels that move nodes: tinygltf requires that of all, and extensions' channels may do
/// otherwise.
Json keptChannels(const Json& source, std::size_t animation, const BrokenAnimations& broken) {
    Json moving = Json::array();
    for (std::size_t i = 0; i < source.size(); ++i) {
        if (broken.channels.contains({animation, i})) continue;
        const Json& channel = source[i];
        if (channel.contains("target") && channel["target"].contains("node"))
            moving.push_back({{"sampler", channel["sampler"]},
                              {"target", only(channel["target"], {"node", "path"})}});
    }
    return moving;
}

/// Keeps samplers that a channel uses. Others may be broken, and get a placeholder.
Json keptSamplers(const Json& source, const Json& channels) {
    Json samplers = Json::array();
    samplers.get_ref<Json::array_t&>().resize(source.size(), Json{{"input", 0}, {"output", 0}});
    for (const Json& channel : channels) {
        const auto index = channel["sampler"].get<std::size_t>();
        samplers[index] = only(source[index], {"input", "output", "interpolation"});
    }
    return samplers;
}

Json keptAnimation(const Json& source, std::size_t index, const BrokenAnimations& broken) {
    Json animation = only(source, {"channels", "samplers"});
    keepOf(animation, "channels",
           [&](const Json& channels) { return keptChannels(channels, index, broken); });
    keepOf(animation, "samplers", [&](const Json& samplers) {
        return keptSamplers(samplers, animation.value("channels", Json::array()));
    });
    return animation;
}

Json keptAnimations(const Json& source, const BrokenAnimations& broken) {
    Json animations = Json::array();
    if (!source.is_array()) return animations; // a warning was already given
    for (std::size_t i = 0; i < source.size(); ++i)
        animations.push_back(broken.whole.contains(i) ? Json::object()
                                                      : keptAnimation(source[i], i, broken));
    return animations;
}

Json keptJson(const Json& source, const BrokenAnimations& brokenAnimations, StandIns& standIns) {
    Json json =
        only(source, {"asset", "scene", "scenes", "nodes", "meshes", "accessors", "bufferViews",
                      "buffers", "materials", "textures", "samplers", "skins", "animations"});
    keepOf(json, "asset", [](const Json& asset) { return only(asset, {"version"}); });
    const auto keepItems = [&json](const char* section, std::initializer_list<const char*> keys) {
        keepOf(json, section, [&](const Json& items) {
            return kept(items, [&](const Json& item) { return only(item, keys); });
        });
    };
    keepItems("scenes", {"nodes"});
    keepItems("nodes", {"children", "matrix", "mesh", "rotation", "scale", "skin", "translation",
                        "weights"});
    keepItems("bufferViews", {"buffer", "byteLength", "byteOffset", "byteStride"});
    keepItems("textures", {"extensions", "sampler", "source"});
    keepItems("samplers", {"magFilter", "minFilter", "wrapS", "wrapT"});
    keepOf(json, "meshes", [](const Json& meshes) { return kept(meshes, keptMesh); });
    keepOf(json, "materials", [](const Json& materials) { return kept(materials, keptMaterial); });
    // tinygltf requires bytes in every buffer, and EXT_meshopt_compression's fallbacks have none.
    keepOf(json, "buffers", [](const Json& buffers) {
        return kept(buffers, [](const Json&) {
            return Json{{"uri", "data:application/octet-stream;base64,AA=="}, {"byteLength", 1}};
        });
    });
    keepOf(json, "accessors",
           [&](const Json& accessors) { return keptAccessors(accessors, standIns.accessors); });
    if (!standIns.accessors.empty() &&
        (!json.contains("bufferViews") || json["bufferViews"].empty()))
        json["bufferViews"] = Json::array({{{"buffer", 0}, {"byteLength", 1}}});
    keepOf(json, "skins", [&](const Json& skins) { return keptSkins(skins, standIns.skins); });
    keepOf(json, "animations",
           [&](const Json& animations) { return keptAnimations(animations, brokenAnimations); });
    return json;
}

} // namespace

tinygltf::Model typedModel(const Json& json, const BrokenAnimations& brokenAnimations,
                           const std::filesystem::path& path) {
    StandIns standIns;
    const std::string text = keptJson(json, brokenAnimations, standIns).dump();
    tinygltf::Model model;
    tinygltf::TinyGLTF loader;
    std::string errors, warnings;
    const bool parsed = loader.LoadASCIIFromString(
        &model, &errors, &warnings, text.data(), static_cast<unsigned>(text.size()), std::string());
    // tinygltf's messages name no field, and the earlier checks should have reported any error
    // already.
    if (!parsed || !errors.empty())
        throw InputError("'" + path.string() + "' is not valid glTF 2.0: it could not be parsed.");
    model.bufferViews.resize(json.contains("bufferViews") ? json["bufferViews"].size() : 0);
    for (const std::size_t accessor : standIns.accessors)
        model.accessors.at(accessor).bufferView = -1;
    for (const std::size_t skin : standIns.skins)
        model.skins.at(skin).inverseBindMatrices = -1;
    return model;
}

} // namespace edgeshade
