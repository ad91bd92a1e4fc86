#include "tests/support/input_error.hpp"
#include "tests/support/meshopt_encoding.hpp"
#include "tests/support/packing.hpp"
#include "tests/support/scene_triangles.hpp"

#include <algorithm>
#include <functional>
#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

/// Expects that packing with any encoding after packing with any other gives the same bytes as
/// packing once.
void expectRepackable(const Bytes& asset) {
    for (const Encoding first : everyEncoding)
        for (const Encoding second : everyEncoding) {
            SCOPED_TRACE(std::string(nameOf(first)) + ", then " + nameOf(second));
            EXPECT_EQ(packed(packed(asset, first), second), packed(asset, second));
        }
}

} // namespace

TEST(Repack, PackingTwiceGivesTheSameBytes) {
    for (const Encoding encoding : everyEncoding)
        EXPECT_EQ(packed(variedScene().glb(), encoding), packed(variedScene().glb(), encoding));
}

TEST(Repack, APackedFilePacksToWhatItsSourcePacksTo) {
    expectRepackable(variedScene().glb());
}

TEST(Repack, ABufferOfAnOddLengthKeepsItsLength) {
    GltfBuilder gltf;
    Shape shape = tetrahedron();
    shape.indices.resize(3);
    gltf.addMesh({{"attributes", {{"POSITION", gltf.addVectors(shape.positions)}}},
                  {"indices", gltf.addIndices<std::uint8_t>(shape.indices)}});
    gltf.addNode({{"mesh", 0}});
    ASSERT_NE(gltf.binary.size() % 4, 0u);
    expectRepackable(gltf.glb());
}

TEST(Repack, ExtensionsOfOthersStayWhereTheyWere) {
    GltfBuilder gltf = variedScene();
    gltf.useExtension("KHR_lights_punctual", false);
    gltf.json["extensions"] = {{"KHR_lights_punctual", {{"lights", Json::array()}}}};
    expectRepackable(gltf.glb());
}

TEST(Repack, SettingsOfTheFirstPackingDoNotMatter) {
    const Bytes asset = variedScene().glb();
    const Bytes masked = packed(asset, Encoding::expanded, {0.1, true});
    EXPECT_EQ(packed(masked, Encoding::indexed), packed(asset, Encoding::indexed));
}

TEST(Repack, SimplifiedCastersAreTakenOutAgain) {
    const Bytes asset = variedScene().glb();
    for (const Encoding first : everyEncoding)
        for (const Encoding second : everyEncoding) {
            const Bytes simplified = packed(asset, first, {0.0, false, 0.2});
            EXPECT_EQ(packed(simplified, second), packed(asset, second));
            EXPECT_EQ(packed(packed(asset, first), second, {0.0, false, 0.2}),
                      packed(asset, second, {0.0, false, 0.2}));
        }
}

TEST(Repack, CompressedVerticesPackAgain) {
    expectRepackable(meshoptScene(box(glm::vec3(1.0f))).glb());
}

TEST(Repack, AFileWhoseShadowDataWereMovedIsRefusedOrReadRightly) {
    // The order that a tool which sorts buffer views might produce: shadow data first, then
    // geometry.
    const GltfBuilder source = variedScene();
    GlbParts parts(packed(source.glb(), Encoding::expanded));
    const std::size_t geometry = source.binary.size();
    const std::size_t shadow = (parts.binary.size() + 3) / 4 * 4;
    const Bytes before = parts.binary;
    parts.binary.insert(parts.binary.end(), shadow - before.size(), 0);
    parts.binary.insert(parts.binary.end(), before.begin(), before.begin() + geometry);
    for (Json& view : parts.json["bufferViews"])
        if (const auto offset = view["byteOffset"].get<std::size_t>(); offset < geometry)
            view["byteOffset"] = offset + shadow;
    parts.json["buffers"][0]["byteLength"] = parts.binary.size();
    ASSERT_EQ(readBack(parts.glb()).size(), 3u);
    Bytes again;
    try {
        again = packed(parts.glb(), Encoding::indexed);
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("rearranged"), std::string::npos);
        return;
    }
    expectSameShadows(readBack(again), built(source.glb()));
}

TEST(Repack, AFileWithoutExtensionsUsedPacksAgain) {
    GlbParts parts(packed(variedScene().glb(), Encoding::indexed));
    parts.json.erase("extensionsUsed");
    EXPECT_EQ(packed(parts.glb(), Encoding::indexed),
              packed(variedScene().glb(), Encoding::indexed));
}

TEST(Repack, AFileWhoseBatchesAreGoneIsRefused) {
    GlbParts parts(packed(variedScene().glb(), Encoding::indexed));
    parts.json["extensions"][shadowExtensionName].erase("batches");
    expectInputError([&] { packed(parts.glb(), Encoding::indexed); },
                     {"test.glb", shadowExtensionName, "batches"});
}

TEST(Repack, APictureWithoutBuffersIsEmbeddedOnce) {
    GltfBuilder gltf;
    gltf.addImage({{"uri", dataUri(smallPng(), "image/png")}});
    expectRepackable(gltf.glb());
}

TEST(Repack, EmptySectionsAreLeftOut) {
    GltfBuilder gltf;
    gltf.json["extensions"] = Json::object();
    for (const char* section : {"extensionsUsed", "accessors", "bufferViews", "images", "skins"})
        gltf.json[section] = Json::array();
    gltf.addNode({{"name", "nothing"}});
    expectRepackable(gltf.glb());
    EXPECT_FALSE(GlbParts(packed(gltf.glb(), Encoding::indexed)).json.contains("skins"));
}

TEST(Repack, TheNameMayBeThereWithoutTheExtension) {
    GltfBuilder gltf = variedScene();
    gltf.json["extensionsUsed"] = {shadowExtensionName, "VENDOR_unknown", shadowExtensionName};
    expectRepackable(gltf.glb());
    EXPECT_EQ(GlbParts(packed(gltf.glb(), Encoding::indexed)).json["extensionsUsed"],
              Json::array({"VENDOR_unknown", shadowExtensionName}));
}

TEST(Repack, AFileWhoseShadowDataAreUsedElsewhereIsRefused) {
    // If they were removed with the shadow data, their indices would be different after packing.
    GltfBuilder gltf = variedScene();
    const int unused = gltf.addArray(std::vector<std::uint8_t>(4), 1);
    const GlbParts sound(packed(gltf.glb(), Encoding::indexed));
    const std::size_t accessor = sound.json["accessors"].size() - 1;
    const std::size_t view = sound.json["bufferViews"].size() - 1;
    const auto expectRefused = [&](const std::function<void(Json&)>& change) {
        GlbParts parts = sound;
        change(parts.json);
        expectInputError([&] { packed(parts.glb(), Encoding::expanded); },
                         {"test.glb", "rearranged"});
    };
    const auto addMesh = [](Json& json, const Json& primitive) {
        json["meshes"].push_back({{"primitives", Json::array({primitive})}});
    };
    expectRefused([&](Json& json) { addMesh(json, {{"attributes", {{"POSITION", accessor}}}}); });
    expectRefused([&](Json& json) {
        addMesh(json, {{"attributes", {{"POSITION", 0}}}, {"indices", accessor}});
    });
    expectRefused([&](Json& json) {
        addMesh(json, {{"attributes", {{"POSITION", 0}}}, {"targets", {{{"POSITION", accessor}}}}});
    });
    expectRefused([&](Json& json) {
        json["skins"] = {{{"joints", Json::array({0})}, {"inverseBindMatrices", accessor}}};
    });
    expectRefused([&](Json& json) { json["images"] = {{{"bufferView", view}}}; });
    expectRefused([&](Json& json) { json["accessors"][unused]["bufferView"] = view; });
}

TEST(Repack, AFileWithAViewBehindTheShadowDataIsRefused) {
    GlbParts parts(packed(variedScene().glb(), Encoding::indexed));
    parts.json["bufferViews"].push_back({{"buffer", 0}, {"byteLength", 4}});
    expectInputError([&] { packed(parts.glb(), Encoding::indexed); }, {"test.glb", "rearranged"});
}

} // namespace edgeshade::test
