#include "preprocess/tinygltf_model.hpp"

#include "preprocess/error.hpp"

namespace edgeshade {
namespace {

using Json = nlohmann::ordered_json;

/// Which items got something that the asset does not have.
struct StandIns {
    std::vector<std::size_t> accessors; ///< got a bufferView
    std::vector<std::size_t> skins;     ///< got inverseBindMatrices
};

/// The section's items, or none.
Json& itemsOf(Json& json, const char* section, Json& none) {
    return json.contains(section) ? json[section] : none;
}

/// tinygltf wants bytes behind every buffer, which EXT_meshopt_compression's fallbacks lack.
void replaceBuffers(Json& buffers) {
    for (Json& buffer : buffers) {
        buffer["uri"] = "data:application/octet-stream;base64,AA==";
        buffer["byteLength"] = 1;
    }
}

/// It wants a view behind every index accessor, which KHR_draco_mesh_compression does not have.
void addViews(Json& json, std::vector<std::size_t>& standIns) {
    Json none = Json::array();
    // Before the accessors are looked up: a new member moves all others of its object.
    if (json.contains("accessors") && itemsOf(json, "bufferViews", none).empty())
        json["bufferViews"] = Json::array({{{"buffer", 0}, {"byteLength", 1}}});
    Json& accessors = itemsOf(json, "accessors", none);
    for (std::size_t i = 0; i < accessors.size(); ++i) {
        if (accessors[i].contains("bufferView")) continue;
        accessors[i]["bufferView"] = 0;
        standIns.push_back(i);
    }
}

/// It wants inverse bind matrices, which are identities where a skin has none.
void addInverseBindMatrices(Json& skins, std::vector<std::size_t>& standIns) {
    for (std::size_t i = 0; i < skins.size(); ++i) {
        if (skins[i].contains("inverseBindMatrices")) continue;
        skins[i]["inverseBindMatrices"] = 0;
        standIns.push_back(i);
    }
}

bool targetsANode(const Json& channel) {
    const auto target = channel.find("target");
    return target != channel.end() && target->contains("node");
}

/// It wants every animation channel to move a node, which those of extensions need not.
void dropChannelsOfOthers(Json& animations) {
    for (Json& animation : animations) {
        if (!animation.contains("channels")) continue;
        Json kept = Json::array();
        for (const Json& channel : animation["channels"])
            if (targetsANode(channel)) kept.push_back(channel);
        animation["channels"] = std::move(kept);
    }
}

/// It refuses materials for faults in textures that nothing here samples.
void dropUnsampledTextures(Json& materials) {
    for (Json& material : materials) {
        for (const char* texture : {"normalTexture", "occlusionTexture", "emissiveTexture"})
            material.erase(texture);
        if (material.contains("pbrMetallicRoughness"))
            material["pbrMetallicRoughness"].erase("metallicRoughnessTexture");
    }
}

Json withStandIns(const Json& source, StandIns& standIns) {
    Json json = source;
    Json none = Json::array();
    json.erase("images"); // read by our own code
    replaceBuffers(itemsOf(json, "buffers", none));
    addViews(json, standIns.accessors);
    dropUnsampledTextures(itemsOf(json, "materials", none));
    addInverseBindMatrices(itemsOf(json, "skins", none), standIns.skins);
    dropChannelsOfOthers(itemsOf(json, "animations", none));
    return json;
}

} // namespace

tinygltf::Model typedModel(const Json& json, const std::filesystem::path& path) {
    StandIns standIns;
    const std::string text = withStandIns(json, standIns).dump();
    tinygltf::Model model;
    tinygltf::TinyGLTF loader;
    std::string errors, warnings;
    const bool parsed = loader.LoadASCIIFromString(
        &model, &errors, &warnings, text.data(), static_cast<unsigned>(text.size()), std::string());
    if (!parsed || !errors.empty())
        throw InputError("'" + path.string() + "' is no valid glTF 2.0: " +
                         (errors.empty() ? "it could not be parsed" : clauseOf(errors)) + ".");
    for (const std::size_t accessor : standIns.accessors)
        model.accessors.at(accessor).bufferView = -1;
    for (const std::size_t skin : standIns.skins)
        model.skins.at(skin).inverseBindMatrices = -1;
    return model;
}

} // namespace edgeshade
