#include "tests/support/gltf_builder.hpp"
#include "tests/support/input_error.hpp"
#include "tests/support/scene_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

const Json turnedAroundZ = {0.0, 0.0, 0.70710678118654752, 0.70710678118654752}; // 90 degrees

std::vector<WorldTriangle> moved(std::vector<WorldTriangle> triangles, const glm::dmat4& matrix) {
    const glm::dmat3 normalMatrix = glm::transpose(glm::inverse(glm::dmat3(matrix)));
    for (WorldTriangle& triangle : triangles)
        for (Corner& corner : triangle) {
            corner.position = glm::dvec3(matrix * glm::dvec4(corner.position, 1.0));
            corner.normal = glm::vec3(glm::normalize(normalMatrix * glm::dvec3(corner.normal)));
        }
    return triangles;
}

std::vector<WorldTriangle> boxTriangles() {
    GltfBuilder gltf;
    gltf.addShapeNode(box(glm::vec3(1.0f)));
    return worldTriangles(sceneOf(gltf));
}

/// A box under a node with the given transform.
Scene boxUnder(Json node) {
    GltfBuilder gltf;
    node["mesh"] = gltf.addShape(box(glm::vec3(1.0f)));
    gltf.addNode(node);
    return sceneOf(gltf);
}

void expectOutwards(const Scene& scene, const glm::dvec3& center) {
    for (const WorldTriangle& triangle : worldTriangles(scene)) {
        EXPECT_GT(glm::dot(outside(triangle), triangle[0].position - center), 0.0);
        for (const Corner& corner : triangle)
            EXPECT_LT(glm::distance(glm::dvec3(corner.normal), outside(triangle)), 1e-6);
    }
}

} // namespace

TEST(Node, TranslationRotationAndScaleApplyFromRightToLeft) {
    const Scene scene =
        boxUnder({{"translation", {10, 0, 0}}, {"rotation", turnedAroundZ}, {"scale", {2, 3, 4}}});
    // x' = 10 - 3 y, y' = 2 x, z' = 4 z
    const glm::dmat4 expected({0, 2, 0, 0}, {-3, 0, 0, 0}, {0, 0, 4, 0}, {10, 0, 0, 1});
    expectSameTriangles(worldTriangles(scene), moved(boxTriangles(), expected), 1e-5);
}

TEST(Node, AMatrixIsColumnMajor) {
    const Scene scene = boxUnder({{"matrix", {0, 2, 0, 0, -3, 0, 0, 0, 0, 0, 4, 0, 10, 0, 0, 1}}});
    const glm::dmat4 expected({0, 2, 0, 0}, {-3, 0, 0, 0}, {0, 0, 4, 0}, {10, 0, 0, 1});
    expectSameTriangles(worldTriangles(scene), moved(boxTriangles(), expected), 1e-6);
}

TEST(Node, ChildrenFollowTheirParents) {
    GltfBuilder gltf;
    const int mesh = gltf.addShape(box(glm::vec3(1.0f)));
    const int leaf = gltf.addNode({{"mesh", mesh}, {"translation", {1, 0, 0}}}, false);
    const int middle = gltf.addNode({{"children", {leaf}}, {"rotation", turnedAroundZ}}, false);
    gltf.addNode({{"children", {middle}}, {"translation", {0, 0, 5}}});
    const glm::dmat4 expected({0, 1, 0, 0}, {-1, 0, 0, 0}, {0, 0, 1, 0}, {0, 1, 5, 1});
    expectSameTriangles(worldTriangles(sceneOf(gltf)), moved(boxTriangles(), expected), 1e-6);
}

TEST(Node, AMillionUnitsAwayAMillimetreRemains) {
    GltfBuilder gltf;
    Shape fine;
    fine.positions = {{0, 0, 0}, {0.001f, 0, 0}, {0, 0.001f, 0}, {1, 1, 1}};
    fine.indices = {0, 1, 2, 1, 2, 3};
    gltf.addNode({{"mesh", gltf.addShape(fine)}, {"translation", {1e6, -2e6, 3e6}}});
    const Scene scene = sceneOf(gltf);
    const auto triangle = worldTriangles(scene).at(0);
    EXPECT_NEAR(glm::distance(triangle[0].position, triangle[1].position), 1e-3, 1e-6);
    EXPECT_NEAR(triangle[0].position.x, 1e6, 1e-6);
    EXPECT_NEAR(triangle[0].position.y, -2e6, 1e-6);
    for (const glm::vec3& position : scene.batches.at(0).geometry->positions)
        EXPECT_LT(glm::length(position), 10.0f);
}

TEST(Node, TheDefaultSceneIsTaken) {
    GltfBuilder gltf;
    const int first = gltf.addShapeNode(tetrahedron());
    const int second = gltf.addShapeNode(box(glm::vec3(1.0f)));
    gltf.json["scenes"] = {{{"nodes", {first}}}, {{"nodes", {second}}}};
    gltf.json["scene"] = 1;
    EXPECT_EQ(sceneOf(gltf).triangleCount(), 12u);
    gltf.json["scene"] = 0;
    EXPECT_EQ(sceneOf(gltf).triangleCount(), 4u);
    gltf.json.erase("scene");
    EXPECT_EQ(sceneOf(gltf).triangleCount(), 4u);
}

TEST(Node, WithoutScenesEveryRootIsTaken) {
    GltfBuilder gltf;
    const int child = gltf.addShapeNode(tetrahedron());
    gltf.addNode({{"children", {child}}, {"translation", {5, 0, 0}}});
    gltf.addShapeNode(box(glm::vec3(1.0f)));
    gltf.json.erase("scenes");
    gltf.json.erase("scene");
    const Scene scene = sceneOf(gltf);
    EXPECT_EQ(scene.triangleCount(), 16u);
    EXPECT_DOUBLE_EQ(worldBounds(scene).high.x, 6.0);
}

TEST(Node, ASceneWithoutMeshesIsEmpty) {
    GltfBuilder gltf;
    gltf.addNode({{"name", "nothing"}});
    EXPECT_EQ(sceneOf(gltf).triangleCount(), 0u);
}

TEST(Node, MirroringKeepsTheOutsideOutside) {
    expectOutwards(boxUnder({{"scale", {-1, 1, 1}}}), glm::dvec3(0.0));
    expectOutwards(boxUnder({{"scale", {-1, -2, -3}}, {"translation", {4, 5, 6}}}),
                   glm::dvec3(4, 5, 6));
}

TEST(Node, MirroringKeepsFlatNormalsOutside) {
    GltfBuilder gltf;
    gltf.addNode({{"mesh", gltf.addShape(tetrahedron())}, {"scale", {1, -1, 1}}});
    expectOutwards(sceneOf(gltf), glm::dvec3(0.25, -0.25, 0.25));
}

TEST(Node, MirroringTwiceIsNoMirroring) {
    GltfBuilder gltf;
    const int mesh = gltf.addShape(box(glm::vec3(1.0f)));
    const int leaf = gltf.addNode({{"mesh", mesh}, {"scale", {-1, 1, 1}}}, false);
    gltf.addNode({{"children", {leaf}}, {"scale", {-1, 1, 1}}});
    expectSameTriangles(worldTriangles(sceneOf(gltf)), boxTriangles());
}

TEST(Node, NormalsStayPerpendicularUnderUnevenScale) {
    // A face of slope 45 degrees.
    Shape slope;
    slope.positions = {{0, 1, 0}, {0, 1, 1}, {1, 0, 0}};
    slope.normals.assign(3, glm::normalize(glm::vec3(1, 1, 0)));
    GltfBuilder gltf;
    gltf.addNode({{"mesh", gltf.addShape(slope)}, {"scale", {10, 1, 1}}});
    const auto triangle = worldTriangles(sceneOf(gltf)).at(0);
    EXPECT_LT(glm::distance(glm::dvec3(triangle[0].normal), outside(triangle)), 1e-6);
}

TEST(Node, AMeshUsedTwiceAppearsTwice) {
    GltfBuilder gltf;
    const int mesh = gltf.addShape(tetrahedron());
    gltf.addNode({{"mesh", mesh}});
    gltf.addNode({{"mesh", mesh}, {"translation", {3, 0, 0}}});
    EXPECT_EQ(sceneOf(gltf).triangleCount(), 8u);
}

TEST(Node, StaticNodesShareOneBatch) {
    GltfBuilder gltf;
    gltf.addShapeNode(tetrahedron());
    gltf.addShapeNode(box(glm::vec3(1.0f)));
    const Scene scene = sceneOf(gltf);
    ASSERT_EQ(scene.batches.size(), 1u);
    EXPECT_EQ(scene.batches[0].node, -1);
}

TEST(Node, AnAnimatedNodeMakesItsOwnBatch) {
    GltfBuilder gltf;
    gltf.addShapeNode(tetrahedron());
    const int animatedNode =
        gltf.addNode({{"mesh", gltf.addShape(box(glm::vec3(1.0f)))}, {"translation", {0, 7, 0}}});
    gltf.animate(animatedNode);
    const Scene scene = sceneOf(gltf);
    ASSERT_EQ(scene.batches.size(), 2u);
    EXPECT_EQ(scene.batches[0].node, -1);
    EXPECT_EQ(scene.batches[1].node, animatedNode);
    EXPECT_EQ(scene.batches[1].geometry->indices.size(), 36u);
    EXPECT_DOUBLE_EQ(scene.batches[1].worldFromBatch[3].y, 7.0);
}

TEST(Node, DescendantsOfAnAnimatedNodeFollowIt) {
    GltfBuilder gltf;
    const int leaf = gltf.addShapeNode(tetrahedron());
    gltf.json["scenes"][0]["nodes"].clear();
    const int middle = gltf.addNode({{"children", {leaf}}, {"translation", {1, 0, 0}}}, false);
    const int animatedNode = gltf.addNode({{"children", {middle}}, {"translation", {0, 2, 0}}});
    gltf.animate(animatedNode, "rotation");
    const Scene scene = sceneOf(gltf);
    ASSERT_EQ(scene.batches.size(), 1u);
    EXPECT_EQ(scene.batches[0].node, animatedNode);
    // Relative to the animated node, so that rotating it rotates them.
    EXPECT_EQ(*std::min_element(scene.batches[0].geometry->positions.begin(),
                                scene.batches[0].geometry->positions.end(),
                                [](auto& a, auto& b) { return a.x < b.x; }),
              glm::vec3(1, 0, 0));
    EXPECT_DOUBLE_EQ(worldBounds(scene).low.y, 2.0);
}

TEST(Node, TheNearestAnimatedNodeMovesAMesh) {
    GltfBuilder gltf;
    const int leaf = gltf.addNode({{"mesh", gltf.addShape(tetrahedron())}}, false);
    const int root =
        gltf.addNode({{"children", {leaf}}, {"mesh", gltf.addShape(box(glm::vec3(1.0f)))}});
    gltf.animate(root);
    gltf.animate(leaf);
    const Scene scene = sceneOf(gltf);
    ASSERT_EQ(scene.batches.size(), 2u);
    for (const Batch& batch : scene.batches)
        EXPECT_EQ(batch.geometry->indices.size(), batch.node == leaf ? 12u : 36u);
}

TEST(Node, AnimatedMorphWeightsDoNotMakeABatch) {
    GltfBuilder gltf;
    const int node = gltf.addShapeNode(tetrahedron());
    gltf.animate(node);
    gltf.json["animations"][0]["channels"][0]["target"]["path"] = "weights";
    EXPECT_EQ(sceneOf(gltf).batches.at(0).node, -1);
}

TEST(Node, AnInvisibleNodeAndWhatIsBelowItAreLeftOut) {
    GltfBuilder gltf;
    gltf.useExtension("KHR_node_visibility");
    const auto visibility = [](bool visible) {
        return Json{{"KHR_node_visibility", {{"visible", visible}}}};
    };
    const int mesh = gltf.addShape(box(glm::vec3(1.0f)));
    const int below = gltf.addNode({{"mesh", mesh}, {"extensions", visibility(true)}}, false);
    gltf.addNode({{"mesh", mesh}, {"children", {below}}, {"extensions", visibility(false)}});
    gltf.addNode({{"mesh", gltf.addShape(tetrahedron())}, {"extensions", visibility(true)}});
    const Scene scene = sceneOf(gltf);
    EXPECT_EQ(scene.triangleCount(), 4u);
    EXPECT_TRUE(scene.warnings.sentences().empty());
    gltf.json["nodes"][1]["extensions"] = {{"KHR_node_visibility", Json::object()}};
    EXPECT_EQ(sceneOf(gltf).triangleCount(), 28u); // visible by default
    gltf.json["nodes"][1]["extensions"] = {{"KHR_node_visibility", {{"visible", "no"}}}};
    expectInputError([&] { sceneOf(gltf); },
                     {"nodes[1].extensions.KHR_node_visibility.visible is \"no\""});
}

TEST(Node, TheWholeSceneMayBeMovedFarAway) {
    GltfBuilder gltf;
    gltf.useExtension("CESIUM_RTC");
    gltf.json["extensions"]["CESIUM_RTC"]["center"] = {1215012.125, -4736313.5, 4081605.25};
    Shape fine;
    fine.positions = {{0, 0, 0}, {0.001f, 0, 0}, {0, 0.001f, 0}, {1, 1, 1}};
    fine.indices = {0, 1, 2, 1, 2, 3};
    gltf.addShapeNode(fine);
    const int moving = gltf.addNode({{"mesh", 0}, {"translation", {10.0, 0.0, 0.0}}});
    gltf.animate(moving);
    const Scene scene = sceneOf(gltf);
    ASSERT_EQ(scene.batches.size(), 2u);
    EXPECT_EQ(scene.batches[0].node, -1);
    const auto triangles = worldTriangles(scene);
    const glm::dvec3 center(1215012.125, -4736313.5, 4081605.25);
    EXPECT_LT(glm::distance(triangles[0][0].position, center), 1e-6);
    EXPECT_NEAR(glm::distance(triangles[0][0].position, triangles[0][1].position), 1e-3, 1e-7);
    EXPECT_LT(glm::distance(triangles[2][0].position, center + glm::dvec3(10, 0, 0)), 1e-6);
    EXPECT_LT(worldBounds(scene).diagonal(), 12.0);

    gltf.json["extensions"]["CESIUM_RTC"]["center"] = {1, 2};
    expectInputError([&] { sceneOf(gltf); }, {"extensions.CESIUM_RTC.center has 2 numbers, not 3"});
}

} // namespace edgeshade::test
