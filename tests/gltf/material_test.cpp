#include "preprocess/gltf/gltf_reading.hpp"
#include "preprocess/reading/material_reading.hpp"

#include "preprocess/mesh/topology.hpp"
#include "tests/support/gltf_builder.hpp"
#include "tests/support/scene_triangles.hpp"

#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

Material materialOf(const Json& json) {
    GltfBuilder gltf;
    gltf.addMaterial(json);
    gltf.json["textures"] = {{{"source", 0}}, {{"source", 1}}};
    Warnings warnings;
    return readMaterials(parseGltf(gltf.glb(), "test.glb"), warnings).at(0);
}

/// Three shapes: opaque (4 triangles), MASK (4) and BLEND (12), listed in the opposite order.
Scene sceneOfEveryAlphaMode() {
    GltfBuilder gltf;
    gltf.addMaterial({{"alphaMode", "BLEND"}});
    gltf.addMaterial({{"alphaMode", "MASK"}, {"alphaCutoff", 0.25}});
    gltf.addMaterial({{"name", "opaque"}});
    gltf.addShapeNode(box(glm::vec3(1.0f)), {{"material", 0}});
    gltf.addShapeNode(tetrahedron(), {{"material", 1}});
    gltf.addShapeNode(tetrahedron(), {{"material", 2}});
    return sceneOf(gltf);
}

} // namespace

TEST(Material, AlphaModesAreRead) {
    EXPECT_EQ(materialOf({{"name", "plain"}}).alphaMode, AlphaMode::opaque);
    EXPECT_EQ(materialOf({{"alphaMode", "OPAQUE"}}).alphaMode, AlphaMode::opaque);
    EXPECT_EQ(materialOf({{"alphaMode", "MASK"}, {"alphaCutoff", 0.25}}).alphaMode,
              AlphaMode::mask);
    EXPECT_EQ(materialOf({{"alphaMode", "MASK"}, {"alphaCutoff", 0.25}}).alphaCutoff, 0.25f);
    EXPECT_EQ(materialOf({{"alphaMode", "MASK"}}).alphaCutoff, 0.5f);
    EXPECT_EQ(materialOf({{"alphaMode", "BLEND"}}).alphaMode, AlphaMode::blend);
}

TEST(Material, UnlitOnesAreTold) {
    EXPECT_FALSE(materialOf({{"name", "plain"}}).unlit);
    EXPECT_TRUE(materialOf({{"extensions", {{"KHR_materials_unlit", Json::object()}}}}).unlit);
}

TEST(Material, TexturesThatAreNotDrawnMayBeBroken) {
    // Unused parts aren't read.
    GltfBuilder gltf;
    gltf.addMaterial(
        {{"normalTexture", Json::object()},
         {"occlusionTexture", {{"index", "one"}}},
         {"emissiveTexture", 7},
         {"emissiveFactor", "bright"},
         {"doubleSided", 1},
         {"pbrMetallicRoughness",
          {{"metallicFactor", "shiny"}, {"metallicRoughnessTexture", {{"index", -1}}}}},
         {"extras", nullptr}});
    gltf.addShapeNode(tetrahedron(), {{"material", 0}});
    EXPECT_EQ(sceneOf(gltf).triangleCount(), 4u);
}

TEST(Material, GroupsStandOpaqueFirstThenMaskThenBlend) {
    const Scene scene = sceneOfEveryAlphaMode();
    const auto& groups = scene.batches.at(0).geometry->groups;
    ASSERT_EQ(groups.size(), 3u);
    EXPECT_EQ(scene.materials[groups[0].material].alphaMode, AlphaMode::opaque);
    EXPECT_EQ(scene.materials[groups[1].material].alphaMode, AlphaMode::mask);
    EXPECT_EQ(scene.materials[groups[2].material].alphaMode, AlphaMode::blend);
}

TEST(Material, OnlyOpaqueTrianglesCast) {
    const Scene scene = sceneOfEveryAlphaMode();
    const Casters casters = castersOf(scene.batches.at(0), scene.materials, false);
    EXPECT_EQ(casters.indices.size(), 3u * 4u);
}

TEST(Material, WithCastMaskedEveryTriangleCasts) {
    const Scene scene = sceneOfEveryAlphaMode();
    const Casters casters = castersOf(scene.batches.at(0), scene.materials, true);
    EXPECT_EQ(casters.indices.size(), 3u * 20u);
}

TEST(Material, BaseColourAndItsTextureAreRead) {
    const Material material = materialOf(
        {{"pbrMetallicRoughness",
          {{"baseColorFactor", {0.1, 0.2, 0.3, 0.4}}, {"baseColorTexture", {{"index", 1}}}}}});
    EXPECT_EQ(material.baseColorFactor, glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
    EXPECT_EQ(material.baseColor().texture, 1);
}

TEST(Material, SpecularGlossinessDiffuseStandsForTheBaseColour) {
    const Material material =
        materialOf({{"pbrMetallicRoughness",
                     {{"baseColorFactor", {0, 0, 0, 1}}, {"baseColorTexture", {{"index", 0}}}}},
                    {"extensions",
                     {{"KHR_materials_pbrSpecularGlossiness",
                       {{"diffuseFactor", {0.5, 0.25, 1, 1}},
                        {"diffuseTexture", {{"index", 1}, {"texCoord", 1}}}}}}}});
    EXPECT_EQ(material.baseColorFactor, glm::vec4(0.5f, 0.25f, 1.0f, 1.0f));
    EXPECT_EQ(material.baseColor().texture, 1);
    EXPECT_EQ(material.baseColor().texcoordSet, 1);
}

TEST(Material, ItsSamplerSaysHowTexelsAreLookedUp) {
    const auto samplerOf = [](const Json& sampler) {
        GltfBuilder gltf;
        gltf.addMaterial({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
        gltf.json["samplers"] = Json::array({sampler});
        gltf.json["textures"] = {{{"source", 0}, {"sampler", 0}}};
        Warnings warnings;
        return readMaterials(parseGltf(gltf.glb(), "test.glb"), warnings).at(0).baseColor().sampler;
    };
    EXPECT_EQ(samplerOf(Json::object()), Sampler());
    EXPECT_TRUE(Sampler().takesMipmaps());
    const Sampler all =
        samplerOf({{"wrapS", 33071}, {"wrapT", 33648}, {"minFilter", 9986}, {"magFilter", 9728}});
    EXPECT_EQ(all, (Sampler{33071, 33648, 9986, 9728}));
    EXPECT_TRUE(all.takesMipmaps());
    EXPECT_FALSE(samplerOf({{"minFilter", 9728}}).takesMipmaps());
    EXPECT_FALSE(samplerOf({{"minFilter", 9729}}).takesMipmaps());
}

TEST(Material, SpecularGlossinessTexturesMayBeTransformed) {
    const Material material = materialOf(
        {{"extensions",
          {{"KHR_materials_pbrSpecularGlossiness",
            {{"diffuseTexture",
              {{"index", 1},
               {"extensions", {{"KHR_texture_transform", {{"offset", {0.5, 0.25}}}}}}}}}}}}});
    EXPECT_EQ(material.baseColor().uvTransform[2], glm::vec3(0.5f, 0.25f, 1.0f));
}

TEST(Material, TextureTransformsAreBakedIntoTexcoords) {
    GltfBuilder gltf;
    gltf.useExtension("KHR_texture_transform", false);
    gltf.addImage({{"uri", dataUri(smallPng(), "image/png")}});
    gltf.json["textures"] = {{{"source", 0}}};
    // Scales by (2, 4), rotates by 90 degrees, moves by (0.5, 0.25): u' = 0.5 + 4 v, v' = 0.25 - 2
    // u.
    gltf.addMaterial({{"pbrMetallicRoughness",
                       {{"baseColorTexture",
                         {{"index", 0},
                          {"extensions",
                           {{"KHR_texture_transform",
                             {{"offset", {0.5, 0.25}},
                              {"rotation", 1.5707963267948966},
                              {"scale", {2, 4}}}}}}}}}}});
    Shape shape;
    shape.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    shape.texcoords = {{0, 0}, {1, 0}, {0, 1}};
    gltf.addShapeNode(shape, {{"material", 0}});
    const auto triangle = worldTriangles(sceneOf(gltf)).at(0);
    EXPECT_LT(glm::distance(triangle[0].texcoord, glm::vec2(0.5f, 0.25f)), 1e-6f);
    EXPECT_LT(glm::distance(triangle[1].texcoord, glm::vec2(0.5f, -1.75f)), 1e-6f);
    EXPECT_LT(glm::distance(triangle[2].texcoord, glm::vec2(4.5f, 0.25f)), 1e-6f);
}

TEST(Material, TheTextureSaysWhichTexcoordsItUses) {
    GltfBuilder gltf;
    gltf.addImage({{"uri", dataUri(smallPng(), "image/png")}});
    gltf.json["textures"] = {{{"source", 0}}};
    gltf.addMaterial(
        {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}, {"texCoord", 1}}}}}});
    Shape shape;
    shape.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    shape.texcoords.assign(3, glm::vec2(0.0f));
    Json primitive = gltf.primitiveOf(shape, {{"material", 0}});
    primitive["attributes"]["TEXCOORD_1"] =
        gltf.addVectors(std::vector<glm::vec2>(3, glm::vec2(0.75f)));
    gltf.addNode({{"mesh", gltf.addMesh(primitive)}});
    EXPECT_EQ(worldTriangles(sceneOf(gltf)).at(0)[0].texcoord, glm::vec2(0.75f));
}

} // namespace edgeshade::test
