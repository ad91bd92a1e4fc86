// The treatment of every extension: the real program draws a scene that requires it, with and
// without it. For a new row call row() with a function that puts the extension into a scene.
#include "preprocess/gltf/extensions.hpp"
#include "tests/cli/documented.hpp"
#include "tests/cli/kept.hpp"
#include "tests/cli/message.hpp"
#include "tests/support/draco_encoding.hpp"
#include "tests/support/meshopt_encoding.hpp"
#include "tests/support/packing.hpp"
#include "tests/support/run_edgeshade.hpp"
#include "tests/support/temp_folder.hpp"
#include "tests/support/webp_encoding.hpp"

#include <algorithm>
#include <functional>
#include <gtest/gtest.h>
#include <map>
#include <set>

namespace edgeshade::test {
/// A row of the table.
struct ExtensionRow {
    std::string name;
    std::function<Bytes()> scene; ///< requires the extension
    bool sameWithout = false;     ///< for an extension that is drawn without a visible effect
    std::vector<std::string> options = {};
    std::vector<std::string> lights = {"--light", "2,6,5"};
};

namespace {

/// A textured box.
GltfBuilder texturedBox() {
    GltfBuilder gltf;
    gltf.addImage({{"uri", dataUri(smallPng(), "image/png")}});
    gltf.json["textures"] = {{{"source", 0}}};
    gltf.addMaterial(
        {{"pbrMetallicRoughness",
          {{"baseColorFactor", {1.0, 0.5, 0.25, 1.0}}, {"baseColorTexture", {{"index", 0}}}}}});
    gltf.addShapeNode(box(glm::vec3(1.0f)), {{"material", 0}});
    return gltf;
}

/// The box, with the extension added by `change`.
ExtensionRow row(const std::string& name, const std::function<void(GltfBuilder&)>& change) {
    return {name, [=] {
                GltfBuilder gltf = texturedBox();
                gltf.useExtension(name);
                change(gltf);
                return gltf.glb();
            }};
}

/// The extension on the box's texture. It refers to another image; without it the texture has an
/// image only if `hasOther`.
ExtensionRow onTexture(const std::string& name, const Bytes& image, bool hasOther) {
    return row(name, [=](GltfBuilder& gltf) {
        const int source = gltf.addImage({{"uri", dataUri(image)}});
        Json& texture = gltf.json["textures"][0];
        texture["extensions"][name] = {{"source", source}};
        if (!hasOther) texture.erase("source");
    });
}

/// The extension on the box's material.
ExtensionRow onMaterial(const std::string& name, const Json& extension) {
    return row(name, [=](GltfBuilder& gltf) {
        gltf.json["materials"][0]["extensions"][name] = extension;
    });
}

/// The extension on the box's material, a glossy dielectric that emits some light.
ExtensionRow onGlossyMaterial(const std::string& name, const Json& extension) {
    return row(name, [=](GltfBuilder& gltf) {
        Json& material = gltf.json["materials"][0];
        material["pbrMetallicRoughness"].update(
            {{"metallicFactor", 0.0}, {"roughnessFactor", 0.3}});
        material["emissiveFactor"] = {0.1, 0.1, 0.1};
        material["extensions"][name] = extension;
    });
}

/// The extension on the box's node.
ExtensionRow onNode(const std::string& name, const Json& extension) {
    return row(name,
               [=](GltfBuilder& gltf) { gltf.json["nodes"][0]["extensions"][name] = extension; });
}

/// The extension on the box's primitive.
ExtensionRow onPrimitive(const std::string& name, const Json& extension) {
    return row(name, [=](GltfBuilder& gltf) {
        gltf.json["meshes"][0]["primitives"][0]["extensions"][name] = extension;
    });
}

/// The extension on the asset itself.
ExtensionRow onAsset(const std::string& name, const Json& extension) {
    return row(name, [=](GltfBuilder& gltf) { gltf.json["extensions"][name] = extension; });
}

Bytes renamed(GltfBuilder gltf, const std::string& from, const std::string& to) {
    std::string text = gltf.json.dump();
    for (std::size_t at; (at = text.find(from)) != std::string::npos;)
        text.replace(at, from.size(), to);
    gltf.json = Json::parse(text);
    return gltf.glb();
}

Bytes quantizedScene() {
    GltfBuilder gltf;
    gltf.useExtension("KHR_mesh_quantization");
    const std::vector<std::int16_t> corners = {-1, -1, 0, 0, 1, -1, 0, 0, 0, 1, 0, 0};
    const int positions = gltf.addAccessor(gltf.addView(bytesOf(corners), 8), 5122, 3, "VEC3");
    gltf.addNode({{"mesh", gltf.addMesh({{"attributes", {{"POSITION", positions}}}})}});
    return gltf.glb();
}

Bytes packedScene() {
    GlbParts parts(packed(texturedBox().glb(), Encoding::indexed));
    parts.json["extensionsRequired"] = parts.json["extensionsUsed"];
    return parts.glb();
}

std::vector<ExtensionRow> compressionRows() {
    const Shape shape = box(glm::vec3(1.0f));
    return {
        {"EXT_meshopt_compression", [=] { return meshoptScene(shape).glb(); }},
        {"KHR_meshopt_compression",
         [=] {
             return renamed(meshoptScene(shape), "EXT_meshopt_compression",
                            "KHR_meshopt_compression");
         }},
        {"KHR_draco_mesh_compression",
         [=] {
             GltfBuilder gltf;
             gltf.useExtension(dracoExtension);
             gltf.addNode({{"mesh", gltf.addMesh(dracoPrimitive(gltf, shape))}});
             return gltf.glb();
         }},
        {"KHR_mesh_quantization", quantizedScene, true},
        {"EDGESHADE_shadow_volume", packedScene, true},
    };
}

/// A spot of the file, in front of the box.
ExtensionRow litRow() {
    const std::string name = "KHR_lights_punctual";
    ExtensionRow lit = row(name, [=](GltfBuilder& gltf) {
        gltf.json["extensions"][name]["lights"] = {
            {{"type", "spot"}, {"spot", {{"outerConeAngle", 0.2}}}}};
        gltf.addNode({{"extensions", {{name, {{"light", 0}}}}}, {"translation", {0.0, 0.0, 4.0}}});
    });
    lit.lights = {};
    return lit;
}

std::vector<ExtensionRow> sceneRows() {
    return {
        row("EXT_mesh_gpu_instancing",
            [](GltfBuilder& gltf) {
                gltf.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
                    {"TRANSLATION", gltf.addArray<float>({0, 0, 0, 2.5f, 0, 0}, 3)}};
            }),
        onNode("KHR_node_visibility", {{"visible", false}}),
        onAsset("CESIUM_RTC", {{"center", {0.5, 0.25, 0.0}}}),
        litRow(),
        onAsset("KHR_xmp_json_ld", {{"packets", Json::array({Json::object()})}}),
        onAsset("EXT_structural_metadata", {{"schema", {{"id", "houses"}}}}),
        onPrimitive("EXT_mesh_features", {{"featureIds", {{{"featureCount", 1}}}}}),
        onPrimitive("FB_ngon_encoding", Json::object()),
        onPrimitive("CESIUM_primitive_outline", {{"indices", 3}}),
    };
}

std::vector<ExtensionRow> materialRows() {
    const std::string variants = "KHR_materials_variants";
    ExtensionRow chosen = row(variants, [=](GltfBuilder& gltf) {
        gltf.addMaterial({{"alphaMode", "OPAQUE"}});
        gltf.json["extensions"][variants]["variants"] = {{{"name", "plain"}}};
        gltf.json["meshes"][0]["primitives"][0]["extensions"][variants]["mappings"] = {
            {{"material", 1}, {"variants", {0}}}};
    });
    chosen.options = {"--variant", "plain"};
    return {
        chosen,
        row("KHR_texture_transform",
            [](GltfBuilder& gltf) {
                Json& metallic = gltf.json["materials"][0]["pbrMetallicRoughness"];
                metallic["baseColorTexture"]["extensions"]["KHR_texture_transform"] = {
                    {"offset", {0.25, 0.5}}, {"scale", {4.0, 3.0}}};
            }),
        onTexture("EXT_texture_webp", smallWebp(), false),
        onTexture("KHR_texture_basisu", Bytes{0xAB, 'K', 'T', 'X', ' ', '2', '0', 0xBB}, true),
        onMaterial("KHR_materials_unlit", Json::object()),
        onMaterial("KHR_materials_pbrSpecularGlossiness", {{"diffuseFactor", {0, 1, 0, 1}}}),
        onMaterial("KHR_materials_anisotropy", {{"anisotropyStrength", 0.5}}),
        onGlossyMaterial("KHR_materials_clearcoat", {{"clearcoatFactor", 1.0}}),
        onMaterial("KHR_materials_diffuse_transmission", {{"diffuseTransmissionFactor", 0.5}}),
        onMaterial("KHR_materials_dispersion", {{"dispersion", 0.1}}),
        onGlossyMaterial("KHR_materials_emissive_strength", {{"emissiveStrength", 2.0}}),
        onGlossyMaterial("KHR_materials_ior", {{"ior", 2.4}}),
        onMaterial("KHR_materials_iridescence", {{"iridescenceFactor", 1.0}}),
        onMaterial("KHR_materials_sheen", {{"sheenColorFactor", {1, 1, 1}}}),
        onGlossyMaterial("KHR_materials_specular", {{"specularFactor", 0.5}}),
        onMaterial("KHR_materials_transmission", {{"transmissionFactor", 1.0}}),
        onMaterial("KHR_materials_volume", {{"thicknessFactor", 1.0}}),
    };
}

std::vector<ExtensionRow> refusedRows() {
    return {
        onNode("MSFT_lod", {{"ids", Json::array()}}),
        onMaterial("KHR_materials_unknown", Json::object()),
        onPrimitive("VENDOR_geometry", Json::object()),
    };
}

std::vector<ExtensionRow> wholeTable() {
    std::vector<ExtensionRow> table;
    for (const auto& part : {compressionRows, sceneRows, materialRows, refusedRows})
        for (ExtensionRow& one : part())
            table.push_back(std::move(one));
    return table;
}

/// Removes the extension from all objects below.
void eraseExtension(Json& json, const std::string& name) {
    if (!json.is_structured()) return;
    if (json.is_object() && json.contains("extensions")) json["extensions"].erase(name);
    for (Json& value : json)
        eraseExtension(value, name);
}

Bytes without(const Bytes& glb, const std::string& name) {
    GlbParts parts(glb);
    eraseExtension(parts.json, name);
    parts.json.erase("extensionsUsed");
    parts.json.erase("extensionsRequired");
    return parts.glb();
}

struct Drawing {
    ProcessResult result;
    Bytes picture; ///< empty if there is none
};

Drawing draw(const Bytes& glb, const ExtensionRow& row) {
    const TempFolder folder;
    std::vector<std::string> arguments = {"render",
                                          folder.write("scene.glb", glb),
                                          folder / "picture.png",
                                          "--size",
                                          "60x40",
                                          "--camera-from",
                                          "3,3,6",
                                          "--camera-to",
                                          "0,0,0"};
    arguments.insert(arguments.end(), row.lights.begin(), row.lights.end());
    arguments.insert(arguments.end(), row.options.begin(), row.options.end());
    Drawing drawing;
    drawing.result = runEdgeshade(arguments);
    if (drawing.result.status == 0) drawing.picture = readFile(folder / "picture.png");
    return drawing;
}

/// Draws the scene of a row of the table once in this process.
const Drawing& drawingOf(const ExtensionRow& row) {
    static std::map<std::string, Drawing> drawings;
    return kept(drawings, row.name, [&] { return draw(row.scene(), row); });
}

/// The program's output, without the folder and the program's name.
std::string saidBy(const ProcessResult& result) {
    std::string said = result.status == 0 ? warningsOf(result) : messageOf(result);
    for (const std::string start : {"edgeshade: ", "warning: "})
        if (said.starts_with(start)) said = said.substr(start.size());
    const std::size_t slash = said.find("/scene.glb");
    if (said.starts_with('\'') && slash != std::string::npos) said.replace(1, slash, "");
    return said;
}

const char* wordFor(ExtensionUse use) {
    switch (use) {
    case ExtensionUse::drawn:
        return "drawn";
    case ExtensionUse::ignored:
        return "ignored";
    default:
        return "metadata";
    }
}

bool lacksSomething(const std::string& name) {
    return std::ranges::any_of(knownExtensions(), [&](const KnownExtension& known) {
        return name == known.name && known.lack != nullptr;
    });
}

/// The outcome according to knownExtensions().
std::string wordFor(const std::string& name) {
    for (const KnownExtension& known : knownExtensions())
        if (name == known.name) return wordFor(known.use);
    return "refused";
}

class ExtensionTest : public testing::TestWithParam<ExtensionRow> {};

} // namespace

void PrintTo(const ExtensionRow& row, std::ostream* stream) {
    *stream << row.name;
}

TEST_P(ExtensionTest, BecomesWhatIsSaid) {
    const ExtensionRow& row = GetParam();
    const Drawing& with = drawingOf(row);
    const Drawing plain = draw(without(row.scene(), row.name), row);
    const std::string word = wordFor(row.name), said = warningsOf(with.result);
    if (word == "refused") {
        EXPECT_EQ(with.result.status, 2);
        expectOneSentence(with.result);
        EXPECT_NE(messageOf(with.result).find(row.name), std::string::npos);
        return;
    }
    ASSERT_EQ(with.result.status, 0) << with.result.err;
    if (word == "drawn" && !row.sameWithout)
        EXPECT_NE(with.picture, plain.picture) << "it makes no difference";
    else
        EXPECT_EQ(with.picture, plain.picture);
    const bool named = said.find(row.name) != std::string::npos;
    // An image in KTX2 is named itself if there is no alternative: see left_out_images.cpp.
    EXPECT_EQ(named, lacksSomething(row.name)) << said;
}

INSTANTIATE_TEST_SUITE_P(Table, ExtensionTest, testing::ValuesIn(wholeTable()),
                         [](const auto& row) { return row.param.name; });

TEST(Extension, AllThatAreKnownAreInTheTable) {
    std::set<std::string> inTable, known;
    for (const ExtensionRow& row : wholeTable())
        if (wordFor(row.name) != "refused") inTable.insert(row.name);
    for (const KnownExtension& extension : knownExtensions())
        known.insert(extension.name);
    EXPECT_EQ(inTable, known);
}

TEST(Extension, TheTableIsDocumented) {
    std::vector<std::string> rows;
    for (const ExtensionRow& row : wholeTable())
        rows.push_back("| " + cellOf(row.name) + " | " + wordFor(row.name) + " | " +
                       cellOf(saidBy(drawingOf(row).result)) + " |");
    expectDocumented("extensions", rows, "extensions.md");
}

} // namespace edgeshade::test
