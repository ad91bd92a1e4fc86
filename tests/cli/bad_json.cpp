// JSON that is none, or that is no glTF.
#include "tests/cli/bad_input.hpp"

namespace edgeshade::test {
namespace {

/// The sound scene with one section replaced.
BadInput section(const std::string& name, const std::string& key, const Json& value) {
    return badScene(name, [=](GltfBuilder& gltf) { gltf.json[key] = value; }, {key});
}

/// `{"asset":{...},"extras":[[[...]]]}`.
std::string nested(std::size_t depth) {
    return R"({"asset":{"version":"2.0"},"extras":)" + std::string(depth, '[') +
           std::string(depth, ']') + "}";
}

} // namespace

std::vector<BadInput> badJson() {
    return {
        badText("Text", "This is not a scene.", {"neither GLB nor JSON"}),
        badText("JsonCutOff", R"({"asset":{"version":"2.0")", {"neither GLB nor JSON"}),
        badText("JsonWithMoreBehind", R"({"asset":{"version":"2.0"}} more)", {"JSON"}),
        badText("JsonOfInvalidUtf8", "{\"asset\":{\"version\":\"2.0\",\"generator\":\"\xFF\"}}",
                {"JSON"}),
        badText("JsonNestedVeryDeep", nested(1000000), {}),
        badText("JsonArray", "[]", {"JSON object"}),
        badText("JsonNumber", "5", {"JSON object"}),
        badText("JsonNull", "null", {"JSON object"}),
        badText("NoAsset", "{}", {"asset"}),
        badText("AssetIsText", R"({"asset":"2.0"})", {"asset"}),
        badText("NoVersion", R"({"asset":{}})", {"version"}),
        badText("VersionIsANumber", R"({"asset":{"version":2.0}})", {"version"}),
        badText("VersionOfGltf1", R"({"asset":{"version":"1.0"}})", {"version"}),
        badText("VersionOfTheFuture", R"({"asset":{"version":"3.0"}})", {"version"}),
        badText("MinVersionOfTheFuture", R"({"asset":{"version":"2.0","minVersion":"2.9"}})",
                {"minVersion"}),
        badScene("UnknownRequiredExtension",
                 [](GltfBuilder& gltf) { gltf.useExtension("VENDOR_geometry"); },
                 {"VENDOR_geometry"}),
        section("NodesAreText", "nodes", "nodes"),
        section("MeshesAreAnObject", "meshes", Json::object()),
        section("AccessorsAreNumbers", "accessors", {1, 2, 3, 4, 5, 6}),
        section("BufferViewsAreNull", "bufferViews", nullptr),
        section("BuffersAreNulls", "buffers", Json::array({nullptr})),
        section("ScenesAreANumber", "scenes", 7),
        section("MaterialsAreArrays", "materials", Json::array({Json::array()})),
        section("ImagesAreText", "images", "images"),
        section("TexturesAreTrue", "textures", true),
        section("SamplersAreANumber", "samplers", 7),
        section("SkinsAreNumbers", "skins", {1}),
        section("AnimationsAreText", "animations", "animations"),
        section("CamerasAreANumber", "cameras", 7),
        section("ExtensionsAreANumber", "extensions", 7),
        section("ExtensionsUsedIsText", "extensionsUsed", "all"),
        section("ExtensionsUsedAreNumbers", "extensionsUsed", {1, 2}),
        section("ExtensionsRequiredIsText", "extensionsRequired", "all"),
        badScene("MeshWithoutPrimitives",
                 [](GltfBuilder& gltf) { gltf.json["meshes"][0].erase("primitives"); },
                 {"primitives"}),
        badScene("PrimitivesAreANumber",
                 [](GltfBuilder& gltf) { gltf.json["meshes"][0]["primitives"] = 7; },
                 {"primitives"}),
        badScene("PrimitiveIsANumber",
                 [](GltfBuilder& gltf) { gltf.json["meshes"][0]["primitives"] = {7}; }, {}),
        badScene("AttributesAreANumber",
                 [](GltfBuilder& gltf) { primitiveOf(gltf)["attributes"] = 7; }, {"attributes"}),
        badScene("AttributeIsText",
                 [](GltfBuilder& gltf) { primitiveOf(gltf)["attributes"]["POSITION"] = "0"; }, {}),
        badScene("ModeIsUnknown", [](GltfBuilder& gltf) { primitiveOf(gltf)["mode"] = 99; },
                 {"mode"}),
    };
}

} // namespace edgeshade::test
