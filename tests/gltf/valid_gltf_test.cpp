// Runs Khronos' validator over packed files drawn in code; skipped if it isn't installed.
#include "tests/support/child_process.hpp"
#include "tests/support/draco_encoding.hpp"
#include "tests/support/meshopt_encoding.hpp"
#include "tests/support/packing.hpp"
#include "tests/support/temp_folder.hpp"
#include "tests/support/webp_encoding.hpp"

#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

const std::filesystem::path validatorFolder = EDGESHADE_VALIDATOR;

/// Expects that the validator, with `options` of its script, finds no error in the asset packed
/// with any encoding.
void expectValid(const Bytes& asset, const std::vector<std::string>& options = {}) {
    if (!std::filesystem::exists(validatorFolder / "node_modules" / "gltf-validator"))
        GTEST_SKIP() << "the glTF validator is not installed";
    const TempFolder folder;
    std::vector<std::string> arguments = {"node", validatorFolder / "validate_packed.mjs"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    for (const Encoding encoding : everyEncoding)
        arguments.push_back(
            folder.write(std::string(nameOf(encoding)) + ".glb", packed(asset, encoding)));
    const ProcessResult result = ChildProcess("/usr/bin/env", arguments).wait(60.0);
    if (result.status == 127) GTEST_SKIP() << "there is no Node.js";
    EXPECT_EQ(result.status, 0) << result.out << result.err;
}

} // namespace

TEST(ValidGltf, AVariedScene) {
    expectValid(variedScene().glb());
}

TEST(ValidGltf, ASceneWithoutTriangles) {
    GltfBuilder gltf;
    gltf.addNode({{"name", "nothing"}});
    expectValid(gltf.glb());
}

TEST(ValidGltf, CompressedByMeshopt) {
    expectValid(meshoptScene(box(glm::vec3(1.0f))).glb());
}

TEST(ValidGltf, CompressedByDraco) {
    GltfBuilder gltf;
    gltf.useExtension(dracoExtension);
    gltf.addNode({{"mesh", gltf.addMesh(dracoPrimitive(gltf, box(glm::vec3(1.0f))))}});
    expectValid(gltf.glb());
}

TEST(ValidGltf, ImagesThatWereEmbedded) {
    GltfBuilder gltf = variedScene();
    gltf.addImage({{"uri", dataUri(smallPng(), "image/png")}});
    gltf.json["textures"] = {{{"source", 0}}};
    gltf.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] = 0;
    expectValid(gltf.glb());
}

TEST(ValidGltf, ImagesOfAFileWithoutBuffers) {
    GltfBuilder gltf;
    gltf.addNode({{"name", "nothing"}});
    gltf.addImage({{"uri", dataUri(smallPng(), "image/png")}});
    gltf.json["textures"] = {{{"source", 0}}};
    gltf.addMaterial({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    expectValid(gltf.glb());
}

TEST(ValidGltf, EmptySections) {
    GltfBuilder gltf;
    gltf.addNode({{"name", "nothing"}});
    for (const char* section : {"accessors", "bufferViews", "images", "meshes", "skins"})
        gltf.json[section] = Json::array();
    expectValid(gltf.glb());
}

TEST(ValidGltf, ImagesThatWereLeftAsTheyAre) {
    GltfBuilder gltf = variedScene();
    for (const char* uri : {"gone.png", "gone.webp", "gone.ktx2"})
        gltf.addImage({{"uri", uri}});
    gltf.useExtension("EXT_texture_webp", false);
    gltf.useExtension("KHR_texture_basisu", false);
    gltf.json["textures"] = {
        {{"source", 0}, {"extensions", {{"EXT_texture_webp", {{"source", 1}}}}}},
        {{"source", 0}, {"extensions", {{"KHR_texture_basisu", {{"source", 2}}}}}}};
    gltf.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] = 0;
    const int second =
        gltf.addMaterial({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 1}}}}}});
    gltf.addShapeNode(box(glm::vec3(0.5f)), {{"material", second}});
    expectValid(gltf.glb(), {"--files-missing"});
}

TEST(ValidGltf, WebpThatWasEmbedded) {
    GltfBuilder gltf = variedScene();
    gltf.addImage({{"uri", dataUri(smallPng(), "image/png")}});
    gltf.addImage({{"uri", dataUri(smallWebp(), "image/webp")}});
    gltf.useExtension("EXT_texture_webp", false);
    gltf.json["textures"] = {
        {{"source", 0}, {"extensions", {{"EXT_texture_webp", {{"source", 1}}}}}}};
    gltf.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] = 0;
    expectValid(gltf.glb());
}

TEST(ValidGltf, WhatWasMended) {
    GltfBuilder gltf = variedScene();
    for (Json& view : gltf.json["bufferViews"])
        view["byteStride"] = 0;
    for (Json& accessor : gltf.json["accessors"])
        for (const char* key : {"bufferView", "componentType", "count"})
            accessor[key] = accessor[key].get<double>();
    gltf.json["nodes"][0]["name"] = 7;
    expectValid(gltf.glb());
}

TEST(ValidGltf, AFallbackThatDoesNotSaySo) {
    GltfBuilder gltf = meshoptScene(box(glm::vec3(1.0f)));
    gltf.json["buffers"][1].erase("extensions");
    expectValid(gltf.glb());
}

} // namespace edgeshade::test
