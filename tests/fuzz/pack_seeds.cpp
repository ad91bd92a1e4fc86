#include "tests/fuzz/seeds.hpp"
#include "tests/support/draco_encoding.hpp"
#include "tests/support/meshopt_encoding.hpp"
#include "tests/support/packing.hpp"

namespace edgeshade::test {
namespace {

/// A box and an animated, skinned tetrahedron below a camera, with everything that a glTF may
/// contain, and images as data URIs.
GltfBuilder completeScene() {
    GltfBuilder gltf;
    gltf.addImage({{"uri", dataUri(smallPng(), "image/png")}, {"name", "picture"}});
    gltf.addImage({{"uri", dataUri(smallPng())}});
    gltf.json["samplers"] = {{{"wrapS", 33071}}};
    gltf.json["textures"] = {{{"source", 0}, {"sampler", 0}}, {{"source", 1}}};
    gltf.addMaterial({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}},
                      {"emissiveTexture", {{"index", 1}}}});
    gltf.json["cameras"] = {
        {{"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.01}}}}};
    const int still = gltf.addShape(box(glm::vec3(1.0f)), {{"material", 0}});
    gltf.addNode({{"mesh", still}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    const int joint =
        gltf.addNode({{"camera", 0}, {"extensions", {{"KHR_lights_punctual", {{"light", 1}}}}}});
    Json primitive = gltf.primitiveOf(tetrahedron());
    primitive["attributes"]["JOINTS_0"] = gltf.addArray(std::vector<std::uint8_t>(16, 0), 4);
    primitive["attributes"]["WEIGHTS_0"] = gltf.addArray(std::vector<float>(16, 0.25f), 4);
    std::vector<float> bind(16, 0.0f);
    bind[0] = bind[5] = bind[10] = bind[15] = 1.0f;
    gltf.json["skins"] = {
        {{"joints", Json::array({joint})}, {"inverseBindMatrices", gltf.addArray(bind, 16)}}};
    gltf.addNode({{"mesh", gltf.addMesh(primitive)}, {"skin", 0}});
    gltf.animate(joint);
    gltf.json["buffers"] = Json::array({Json::object()});
    gltf.useExtension("KHR_lights_punctual");
    gltf.json["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "point"}}, {{"type", "spot"}, {"spot", {{"outerConeAngle", 0.5}}}}};
    return gltf;
}

void eraseKey(Json& value, const std::string& key) {
    if (value.is_object()) value.erase(key);
    if (value.is_structured())
        for (Json& child : value)
            eraseKey(child, key);
}

/// References to a section: sections that require it, and keys somewhere below others.
struct Dependents {
    std::vector<const char*> sections;
    std::vector<std::pair<const char*, const char*>> keys; ///< section and key
};

Dependents dependentsOf(const std::string& section) {
    if (section == "buffers") return {{"bufferViews"}, {}};
    if (section == "bufferViews") return {{"accessors"}, {}};
    if (section == "accessors")
        return {{"meshes", "animations"}, {{"skins", "inverseBindMatrices"}}};
    if (section == "meshes") return {{}, {{"nodes", "mesh"}, {"nodes", "skin"}}};
    if (section == "nodes") return {{"skins", "animations"}, {{"scenes", "nodes"}}};
    if (section == "skins") return {{}, {{"nodes", "skin"}}};
    if (section == "cameras") return {{}, {{"nodes", "camera"}}};
    if (section == "scenes") return {{"scene"}, {}};
    if (section == "materials") return {{}, {{"meshes", "material"}}};
    if (section == "textures")
        return {{}, {{"materials", "baseColorTexture"}, {"materials", "emissiveTexture"}}};
    if (section == "images") return {{}, {{"textures", "source"}}};
    if (section == "samplers") return {{}, {{"textures", "sampler"}}};
    if (section == "extensions" || section == "extensionsUsed")
        return {{"extensions", "extensionsUsed", "extensionsRequired"}, {{"nodes", "extensions"}}};
    return {};
}

void eraseSection(Json& json, const std::string& section) {
    if (!json.contains(section)) return;
    json.erase(section);
    const Dependents dependents = dependentsOf(section);
    for (const char* other : dependents.sections)
        eraseSection(json, other);
    for (const auto& [other, key] : dependents.keys)
        if (json.contains(other)) eraseKey(json[other], key);
}

/// The complete scene without a section and all references to it.
Bytes without(const std::string& section) {
    GltfBuilder gltf = completeScene();
    eraseSection(gltf.json, section);
    if (section == "buffers") gltf.binary.clear();
    return gltf.glb();
}

Bytes onlyAnImage() {
    GltfBuilder gltf;
    gltf.json = {{"asset", {{"version", "2.0"}}}};
    gltf.addImage({{"uri", dataUri(smallPng(), "image/png")}});
    return gltf.glb();
}

/// The bytes in a second buffer, a data URI.
Bytes twoBuffers() {
    GltfBuilder gltf = completeScene();
    gltf.json["buffers"] = {
        Json::object(),
        {{"byteLength", gltf.binary.size()}, {"uri", dataUri(gltf.binary)}, {"name", "second"}}};
    for (Json& view : gltf.json["bufferViews"])
        view["buffer"] = 1;
    gltf.binary = {1, 2, 3};
    return gltf.glb();
}

Bytes meshoptWithImage() {
    GltfBuilder gltf = meshoptScene(box(glm::vec3(1.0f)));
    gltf.addImage({{"uri", dataUri(smallPng(), "image/png")}});
    return gltf.glb();
}

Bytes dracoWithImage() {
    GltfBuilder gltf;
    gltf.useExtension(dracoExtension);
    gltf.addNode({{"mesh", gltf.addMesh(dracoPrimitive(gltf, box(glm::vec3(1.0f))))}});
    gltf.addImage({{"uri", dataUri(smallPng(), "image/png")}});
    return gltf.glb();
}

} // namespace

Seeds packSeeds() {
    const GltfBuilder complete = completeScene();
    Seeds seeds = {{"complete.glb", complete.glb()},
                   {"only_an_image.glb", onlyAnImage()},
                   {"two_buffers.glb", twoBuffers()},
                   {"meshopt.glb", meshoptWithImage()},
                   {"draco.glb", dracoWithImage()}};
    for (const auto& section : complete.json.items())
        if (section.key() != "asset")
            seeds.emplace_back("no_" + section.key() + ".glb", without(section.key()));
    for (const Encoding encoding : everyEncoding)
        seeds.emplace_back(std::string("packed_") + nameOf(encoding) + ".glb",
                           packed(complete.glb(), encoding));
    return seeds;
}

} // namespace edgeshade::test
