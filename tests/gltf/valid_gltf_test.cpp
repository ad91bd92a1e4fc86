// Khronos' validator over packed files drawn in code; skipped where it isn't installed.
#include "tests/support/child_process.hpp"
#include "tests/support/draco_encoding.hpp"
#include "tests/support/meshopt_encoding.hpp"
#include "tests/support/packing.hpp"
#include "tests/support/temp_folder.hpp"

#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

const std::filesystem::path validatorFolder = EDGESHADE_VALIDATOR;

/// Expects that the validator finds no error in the asset packed with any encoding.
void expectValid(const Bytes& asset) {
    if (!std::filesystem::exists(validatorFolder / "node_modules" / "gltf-validator"))
        GTEST_SKIP() << "the glTF validator is not installed";
    const TempFolder folder;
    std::vector<std::string> arguments = {"node", validatorFolder / "validate_packed.mjs"};
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
