#include "tests/support/gltf_builder.hpp"
#include "tests/support/scene_triangles.hpp"

#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

std::vector<float> matrixOfTranslation(float x, float y, float z) {
    return {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1};
}

/// A tetrahedron with corner 1 on joint 1 and the other corners on joint 0. At rest joint 0 is
/// where it was bound, joint 1 is 2 above.
GltfBuilder skinnedScene() {
    GltfBuilder gltf;
    const int second = gltf.addNode({{"translation", {0, 3, 0}}}, false);
    const int first = gltf.addNode({{"children", {second}}, {"translation", {5, 0, 0}}});
    std::vector<float> inverseBind = matrixOfTranslation(-5, 0, 0);
    for (const float value : matrixOfTranslation(-5, -1, 0))
        inverseBind.push_back(value);
    gltf.json["skins"] = {
        {{"joints", {first, second}}, {"inverseBindMatrices", gltf.addArray(inverseBind, 16)}}};
    Json primitive = gltf.primitiveOf(tetrahedron());
    primitive["attributes"]["JOINTS_0"] =
        gltf.addArray<std::uint8_t>({0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, 4);
    primitive["attributes"]["WEIGHTS_0"] =
        gltf.addArray<float>({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, 4);
    // A skinned node's own transform does not count.
    gltf.addNode({{"mesh", gltf.addMesh(primitive)}, {"skin", 0}, {"translation", {99, 99, 99}}});
    return gltf;
}

std::vector<WorldTriangle> tetrahedronWithCorner(const glm::vec3& corner) {
    Shape shape = tetrahedron();
    shape.positions[1] = corner;
    GltfBuilder gltf;
    gltf.addShapeNode(shape);
    return worldTriangles(sceneOf(gltf));
}

/// A tetrahedron with a target that moves corner 1 by (0, 4, 0) at full weight.
GltfBuilder morphedScene(const Json& meshWeights, const Json& nodeWeights) {
    GltfBuilder gltf;
    Json primitive = gltf.primitiveOf(tetrahedron());
    primitive["targets"] = {{{"POSITION", gltf.addVectors(std::vector<glm::vec3>{
                                              {0, 0, 0}, {0, 4, 0}, {0, 0, 0}, {0, 0, 0}})}}};
    const int mesh = gltf.addMesh(primitive);
    if (!meshWeights.is_null()) gltf.json["meshes"][mesh]["weights"] = meshWeights;
    Json node = {{"mesh", mesh}};
    if (!nodeWeights.is_null()) node["weights"] = nodeWeights;
    gltf.addNode(node);
    return gltf;
}

} // namespace

TEST(Skin, VerticesStandWhereTheirJointsAreAtRest) {
    const Scene scene = sceneOf(skinnedScene());
    expectSameTriangles(worldTriangles(scene), tetrahedronWithCorner({1, 2, 0}), 1e-6);
    EXPECT_TRUE(scene.warnings.sentences().empty());
}

TEST(Skin, TwoNodesMayHaveOneSkin) {
    GltfBuilder gltf = skinnedScene();
    gltf.addNode({{"mesh", 0}, {"skin", 0}});
    const Scene scene = sceneOf(gltf);
    EXPECT_EQ(scene.triangleCount(), 8u);
}

TEST(Skin, WithoutInverseBindMatricesTheyAreIdentities) {
    GltfBuilder gltf = skinnedScene();
    gltf.json["skins"][0].erase("inverseBindMatrices");
    const Scene scene = sceneOf(gltf);
    EXPECT_DOUBLE_EQ(worldBounds(scene).low.x, 5.0);
    EXPECT_DOUBLE_EQ(worldBounds(scene).high.y, 3.0);
}

TEST(Skin, WeightsBlendJoints) {
    GltfBuilder gltf = skinnedScene();
    gltf.json["meshes"][0]["primitives"][0]["attributes"]["JOINTS_0"] =
        gltf.addArray<std::uint16_t>({0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, 4);
    gltf.json["meshes"][0]["primitives"][0]["attributes"]["WEIGHTS_0"] =
        gltf.addArray<std::uint8_t>({255, 0, 0, 0, 51, 204, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0}, 4,
                                    {{"normalized", true}});
    expectSameTriangles(worldTriangles(sceneOf(gltf)), tetrahedronWithCorner({1, 1.6f, 0}), 1e-5);
}

TEST(Skin, VerticesWithoutWeightsGoWithTheirFirstJoint) {
    for (const std::vector<float>& none : {std::vector<float>{0, 0, 0, 0}, {0.5f, -0.5f, 0, 0}}) {
        GltfBuilder gltf = skinnedScene();
        std::vector<float> weights = {1, 0, 0, 0};
        weights.insert(weights.end(), none.begin(), none.end());
        weights.insert(weights.end(), {1, 0, 0, 0, 1, 0, 0, 0});
        gltf.json["meshes"][0]["primitives"][0]["attributes"]["WEIGHTS_0"] =
            gltf.addArray(weights, 4);
        expectSameTriangles(worldTriangles(sceneOf(gltf)), tetrahedronWithCorner({1, 2, 0}), 1e-6);
    }
}

TEST(Skin, WhatItsNodeMirrorsShowsItsOtherSide) {
    // The joints keep it in place; the mesh's node decides which side is the front (glTF 2.0,
    // 3.7.4).
    GltfBuilder gltf = skinnedScene();
    const auto plain = worldTriangles(sceneOf(gltf));
    gltf.json["nodes"].back()["scale"] = {-1, 1, 1};
    const auto turned = worldTriangles(sceneOf(gltf));
    ASSERT_EQ(turned.size(), plain.size());
    for (std::size_t i = 0; i < turned.size(); ++i)
        EXPECT_LT(glm::distance(outside(turned[i]), -outside(plain[i])), 1e-6);
    gltf.json["nodes"].back()["scale"] = {1, 1, 1};
    gltf.json["nodes"][1]["scale"] = {-1, 1, 1}; // only of the first joint
    const auto inside = worldTriangles(sceneOf(gltf));
    EXPECT_LT(inside[0][0].position.x, 12.0);
    EXPECT_EQ(inside[0][1].texcoord, plain[0][1].texcoord) << "no corners are swapped";
}

TEST(Morph, DefaultWeightsOfTheMeshApply) {
    const Scene scene = sceneOf(morphedScene({0.5}, nullptr));
    expectSameTriangles(worldTriangles(scene), tetrahedronWithCorner({1, 2, 0}), 1e-6);
    EXPECT_TRUE(scene.warnings.sentences().empty());
}

TEST(Morph, WeightsOfTheNodeComeFirst) {
    expectSameTriangles(worldTriangles(sceneOf(morphedScene({0.5}, {0.25}))),
                        tetrahedronWithCorner({1, 1, 0}), 1e-6);
}

TEST(Morph, WithoutWeightsNothingMoves) {
    expectSameTriangles(worldTriangles(sceneOf(morphedScene(nullptr, nullptr))),
                        tetrahedronWithCorner({1, 0, 0}));
}

} // namespace edgeshade::test
