// Assets that glTF 2.0 allows but few writers make: they must be read.
#include "preprocess/gltf/glb.hpp"
#include "tests/support/gltf_builder.hpp"
#include "tests/support/scene_triangles.hpp"

#include <functional>
#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

/// Expects that a box's twelve triangles are still read after `change`.
void expectStillRead(const std::function<void(Json&)>& change) {
    GltfBuilder gltf;
    const int node = gltf.addShapeNode(box(glm::vec3(1.0f)));
    gltf.animate(node);
    change(gltf.json);
    EXPECT_EQ(sceneOf(gltf).triangleCount(), 12u);
}

} // namespace

TEST(OddButValid, ASceneMayHaveNoNodes) {
    GltfBuilder gltf;
    gltf.json["scenes"][0].erase("nodes");
    EXPECT_EQ(sceneOf(gltf).triangleCount(), 0u);
}

TEST(OddButValid, AnAssetMayHoldNothing) {
    GltfBuilder gltf;
    gltf.json = {{"asset", {{"version", "2.0"}}}};
    EXPECT_EQ(sceneOf(gltf).triangleCount(), 0u);
}

TEST(OddButValid, AnAnimationMayTargetNoNode) {
    // The target that KHR_animation_pointer uses.
    expectStillRead([](Json& json) {
        json["animations"][0]["channels"][0]["target"] = {{"path", "pointer"}};
    });
}

TEST(OddButValid, AMinorVersionMayBeNewer) {
    expectStillRead([](Json& json) { json["asset"]["version"] = "2.1"; });
}

TEST(OddButValid, ATextureMayHaveNoSource) {
    expectStillRead([](Json& json) {
        json["textures"] = Json::array({Json::object()});
        json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
        json["meshes"][0]["primitives"][0]["material"] = 0;
    });
}

TEST(OddButValid, ASamplerMayBeEmpty) {
    expectStillRead([](Json& json) { json["samplers"] = Json::array({Json::object()}); });
}

TEST(OddButValid, CamerasAndLightsMayBeThere) {
    expectStillRead([](Json& json) {
        json["cameras"] = {
            {{"type", "orthographic"},
             {"orthographic", {{"xmag", 1.0}, {"ymag", 1.0}, {"znear", 0.0}, {"zfar", 1.0}}}},
            {{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}}}}};
        json["nodes"][0]["camera"] = 0;
        json["extensionsUsed"] = {"KHR_lights_punctual"};
        json["extensions"]["KHR_lights_punctual"]["lights"] = {
            {{"type", "spot"}, {"spot", Json::object()}}, {{"type", "point"}}};
        json["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 0;
    });
}

TEST(OddButValid, ExtensionsOfOthersMayStandAnywhere) {
    expectStillRead([](Json& json) {
        const Json foreign = {{"VENDOR_unknown", {{"list", {1, "two", nullptr}}}}};
        json["extensionsUsed"] = {"VENDOR_unknown"};
        json["extensions"] = json["nodes"][0]["extensions"] = json["meshes"][0]["extensions"] =
            json["meshes"][0]["primitives"][0]["extensions"] = json["accessors"][0]["extensions"] =
                json["bufferViews"][0]["extensions"] = json["scenes"][0]["extensions"] = foreign;
    });
}

TEST(OddButValid, TextMayBeEscaped) {
    expectStillRead([](Json& json) { json["nodes"][0]["name"] = "\xE2\x82\xAC \"\\ \n"; });
}

TEST(OddButValid, AnUnusedPrimitiveMayNameAnyAttribute) {
    expectStillRead([](Json& json) {
        auto& attributes = json["meshes"][0]["primitives"][0]["attributes"];
        attributes["_TEMPERATURE"] = attributes["TEXCOORD_7"] = attributes["TEXCOORD_0"];
    });
}

TEST(OddButValid, AGlbMayHaveFurtherChunks) {
    GltfBuilder gltf;
    gltf.addShapeNode(box(glm::vec3(1.0f)));
    Bytes glb = gltf.glb();
    const Bytes further = {4, 0, 0, 0, 'X', 'T', 'R', 'A', 1, 2, 3, 4};
    glb.insert(glb.end(), further.begin(), further.end());
    for (int i = 0; i < 4; ++i)
        glb[8 + i] = static_cast<std::uint8_t>(glb.size() >> 8 * i);
    EXPECT_EQ(sceneOf(glb).triangleCount(), 12u);
}

TEST(OddButValid, AStridedViewMayEndWithItsLastElement) {
    // Two interleaved attributes, with no padding behind the last element.
    GltfBuilder gltf;
    const std::vector<float> values = {0, 0, 0, 9, 1, 0, 0, 9, 0, 1, 0};
    const int positions =
        gltf.addAccessor(gltf.addView(bytesOf(values), 16), componentTypeOf<float>, 3, "VEC3");
    gltf.addNode({{"mesh", gltf.addMesh({{"attributes", {{"POSITION", positions}}}})}});
    EXPECT_EQ(sceneOf(gltf).triangleCount(), 1u);
}

} // namespace edgeshade::test
