// Invalid JSON, and JSON that is not glTF.
#include "preprocess/gltf/glb.hpp"
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

/// The sound scene with a name that is not UTF-8.
std::string inLatin1() {
    GltfBuilder gltf = soundScene();
    gltf.json["nodes"][0]["name"] = "caf?";
    std::string text = gltf.gltf();
    text[text.find("caf?") + 3] = '\xE9';
    return text;
}

} // namespace

std::vector<BadInput> badJson() {
    return {
        badText("Text", "This is not a scene.", {"is neither GLB nor JSON."}),
        badText("JsonCutOff", R"({"asset":{"version":"2.0")",
                {"invalid JSON", "at byte 26", "ends too early"}),
        badText("JsonWithMoreBehind", R"({"asset":{"version":"2.0"}} more)",
                {"invalid JSON", "at byte 29", "not allowed"}),
        badText("JsonWithAMarkOfUtf8", "\xEF\xBB\xBF{\"asset\":7,}", {"invalid JSON", "at byte"}),
        badBytes("JsonChunkOfText", [] { return joinGlb("scene", {}); },
                 {"invalid JSON", "at byte 1:"}),
        warned(badText("JsonInLatin1", inLatin1(), {"not UTF-8", "at byte", "U+FFFD"})),
        badText("FileNamedInLatin1",
                "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":1,"
                "\"uri\":\"caf\xE9.bin\"}]}",
                {"buffers[0].uri", "caf\xEF\xBF\xBD.bin' does not exist"}),
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
        warned(section("AnimationsAreText", "animations", "animations")),
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
        badScene("CountIsNoWholeNumber",
                 [](GltfBuilder& gltf) { gltf.json["accessors"][0]["count"] = 1.5; },
                 {"accessors[0].count is 1.5", "a whole number"}),
        badScene("CountIsAHugeNumber",
                 [](GltfBuilder& gltf) { gltf.json["accessors"][0]["count"] = 1e30; },
                 {"accessors[0].count is 1e+30", "a whole number"}),
        badScene("ModeIsNoWholeNumber", [](GltfBuilder& gltf) { primitiveOf(gltf)["mode"] = 4.5; },
                 {"mode is 4.5", "a whole number"}),
        badScene("ModeIsUnknown", [](GltfBuilder& gltf) { primitiveOf(gltf)["mode"] = 99; },
                 {"mode"}),
    };
}

} // namespace edgeshade::test
