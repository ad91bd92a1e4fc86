// EXT_mesh_gpu_instancing: a node's mesh in many places, each of which is drawn and casts.
#include "preprocess/base/limits.hpp"
#include "preprocess/gltf/gltf_reading.hpp"
#include "preprocess/mesh/topology.hpp"
#include "preprocess/packing/shadow_extension.hpp"
#include "preprocess/reading/animation_reading.hpp"
#include "preprocess/reading/flatten.hpp"
#include "preprocess/scene/animation.hpp"
#include "preprocess/volumes/plane_pair_data.hpp"
#include "tests/support/gltf_builder.hpp"
#include "tests/support/input_error.hpp"
#include "tests/support/moving_scenes.hpp"
#include "tests/support/packing.hpp"
#include "tests/support/scene_triangles.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

const Json turnedAroundZ = {0.0, 0.0, 0.70710678118654752, 0.70710678118654752}; // 90 degrees

Json instancing(const Json& attributes) {
    return {{"EXT_mesh_gpu_instancing", {{"attributes", attributes}}}};
}

/// Three tetrahedra of one node: moved, rotated and scaled, the last mirrored.
struct Instances {
    GltfBuilder gltf;
    int node = 0;

    explicit Instances(bool required = true) {
        gltf.useExtension("EXT_mesh_gpu_instancing", required);
        const int translations = gltf.addArray<float>({0, 0, 0, 5, 0, 0, 0, 7, 0}, 3);
        const int rotations =
            gltf.addArray<float>({0, 0, 0, 1, 0, 0, 0.70710678f, 0.70710678f, 0, 0, 0, 1}, 4);
        const int scales = gltf.addArray<float>({1, 1, 1, 2, 2, 2, -1, 1, 1}, 3);
        node = gltf.addNode({{"mesh", gltf.addShape(tetrahedron())},
                             {"translation", {0.0, 0.0, 3.0}},
                             {"extensions", instancing({{"TRANSLATION", translations},
                                                        {"ROTATION", rotations},
                                                        {"SCALE", scales}})}});
    }
    Json& attributes() {
        return gltf.json["nodes"][node]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
    }
    void expectRefused(std::initializer_list<const char*> words) const {
        expectInputError([&] { sceneOf(gltf); }, words);
    }
};

/// The same, each as a node of its own.
GltfBuilder asNodes() {
    GltfBuilder gltf;
    const int mesh = gltf.addShape(tetrahedron());
    const Json nodes = {{{"mesh", mesh}},
                        {{"mesh", mesh},
                         {"translation", {5, 0, 0}},
                         {"rotation", turnedAroundZ},
                         {"scale", {2, 2, 2}}},
                        {{"mesh", mesh}, {"translation", {0, 7, 0}}, {"scale", {-1, 1, 1}}}};
    Json children = Json::array();
    for (const Json& node : nodes)
        children.push_back(gltf.addNode(node, false));
    gltf.addNode({{"children", children}, {"translation", {0.0, 0.0, 3.0}}});
    return gltf;
}

} // namespace

TEST(Instances, AreDrawnLikeNodesOfTheirOwn) {
    for (const bool required : {true, false}) {
        const Scene scene = sceneOf(Instances(required).gltf);
        expectSameTriangles(worldTriangles(scene), worldTriangles(sceneOf(asNodes())), 1e-6);
        EXPECT_TRUE(scene.warnings.sentences().empty());
    }
}

TEST(Instances, AllCast) {
    const Scene scene = sceneOf(Instances().gltf);
    EXPECT_EQ(castersOf(scene.batches.at(0), scene.materials, false).indices.size(), 3u * 4u * 3u);
}

TEST(Instances, ArePackedAsTheyAre) {
    const Bytes asset = Instances().gltf.glb();
    const Bytes packedAsset = packed(asset, Encoding::indexed);
    EXPECT_EQ(worldTriangles(sceneOf(packedAsset)).size(), 12u);
    expectSameShadows(readBack(packedAsset), built(asset));
}

TEST(Instances, MayHaveSomeAttributesAlone) {
    Instances moved;
    moved.attributes().erase("ROTATION");
    moved.attributes().erase("SCALE");
    EXPECT_EQ(worldBounds(sceneOf(moved.gltf)).high, glm::dvec3(6, 8, 4));
    Instances counted; // a custom attribute gives the number of instances
    counted.attributes() = {{"_ID", counted.gltf.addArray<float>({1, 2}, 1)}};
    EXPECT_EQ(sceneOf(counted.gltf).triangleCount(), 8u);
}

TEST(Instances, WithoutAttributesTheMeshIsDrawnOnce) {
    for (const Json& extension : {Json({{"attributes", Json::object()}}), Json::object()}) {
        Instances scene;
        scene.gltf.json["nodes"][scene.node]["extensions"]["EXT_mesh_gpu_instancing"] = extension;
        GltfBuilder once = scene.gltf;
        once.json["nodes"][scene.node].erase("extensions");
        const Scene flat = sceneOf(scene.gltf);
        expectSameTriangles(worldTriangles(flat), worldTriangles(sceneOf(once)));
        ASSERT_EQ(flat.warnings.sentences().size(), 1u);
        EXPECT_EQ(warningsWith(flat, "drawn once"), 1u);
    }
}

TEST(Instances, MayBeNone) {
    Instances scene;
    scene.attributes() = {{"TRANSLATION", scene.gltf.addAccessor(-1, 5126, 0, "VEC3")}};
    EXPECT_EQ(sceneOf(scene.gltf).triangleCount(), 0u);
}

TEST(Instances, RotationsMayBeSmallIntegers) {
    const auto expected = worldTriangles(sceneOf(asNodes()));
    Instances shorts;
    shorts.attributes()["ROTATION"] = shorts.gltf.addArray<std::int16_t>(
        {0, 0, 0, 32767, 0, 0, 23170, 23170, 0, 0, 0, 32767}, 4, {{"normalized", true}});
    expectSameTriangles(worldTriangles(sceneOf(shorts.gltf)), expected, 1e-5);
    Instances bytes; // 90/127 is not the cosine of 45 degrees, but the direction is right
    bytes.attributes()["ROTATION"] = bytes.gltf.addArray<std::int8_t>(
        {0, 0, 0, 127, 0, 0, 90, 90, 0, 0, 0, 127}, 4, {{"normalized", true}});
    expectSameTriangles(worldTriangles(sceneOf(bytes.gltf)), expected, 1e-5);
}

TEST(Instances, OfQuantizedMeshes) {
    GltfBuilder gltf;
    gltf.useExtension("KHR_mesh_quantization");
    gltf.useExtension("EXT_mesh_gpu_instancing");
    const std::vector<std::int16_t> corners = {0, 0, 0, 0, 100, 0, 0, 0, 0, 100, 0, 0};
    const int positions = gltf.addAccessor(gltf.addView(bytesOf(corners), 8), 5122, 3, "VEC3");
    const int translations = gltf.addArray<float>({0, 0, 0, 5, 0, 0}, 3);
    gltf.addNode({{"mesh", gltf.addMesh({{"attributes", {{"POSITION", positions}}}})},
                  {"scale", {0.01, 0.01, 0.01}},
                  {"extensions", instancing({{"TRANSLATION", translations}})}});
    EXPECT_EQ(sceneOf(gltf).triangleCount(), 2u);
    EXPECT_NEAR(worldBounds(sceneOf(gltf)).high.x, 1.05, 1e-6); // scaled by the node
}

TEST(Instances, FollowAnAnimatedNode) {
    Instances scene;
    scene.gltf.animate(scene.node);
    const Scene flat = sceneOf(scene.gltf);
    ASSERT_EQ(flat.batches.size(), 1u);
    EXPECT_EQ(flat.batches[0].node, scene.node);
    expectSameTriangles(worldTriangles(flat), worldTriangles(sceneOf(asNodes())), 1e-6);
}

TEST(Instances, AreCountedBeforeTheyAreMade) {
    Instances scene;
    ReadingLimits limits;
    limits.triangles = 11;
    expectInputError([&] { flattenScene(parseGltf(scene.gltf.glb(), "test.glb", limits), 0.0); },
                     {"nodes[0] brings the scene to 12 triangles", "limit is 11"});
    // A count that is only claimed.
    Instances many;
    many.attributes() = {{"TRANSLATION", many.gltf.addAccessor(-1, 5126, 16'000'000, "VEC3")}};
    many.expectRefused({"nodes[0] brings the scene to 64000000 triangles"});
    limits = {};
    limits.triangles = 100'000'000;
    limits.memoryBytes = 1'000'000'000;
    expectInputError([&] { flattenScene(parseGltf(many.gltf.glb(), "test.glb", limits), 0.0); },
                     {"nodes[0] takes", "the limit is 1000000000"});
}

Scene sharedSceneOf(const GltfBuilder& gltf, double weldTolerance = 0.0) {
    return flattenScene(parseGltf(gltf.glb(), "test.glb"), weldTolerance, {},
                        InstanceChoice::shared);
}

TEST(Instances, MayShareTheirMesh) {
    for (const GltfBuilder& gltf : {Instances().gltf, asNodes()}) {
        const Scene scene = sharedSceneOf(gltf);
        ASSERT_EQ(scene.batches.size(), 3u);
        EXPECT_EQ(firstOfGeometry(scene.batches), (std::vector<std::size_t>{0, 0, 0}));
        EXPECT_EQ(scene.triangleCount(), 12u);
        expectSameTriangles(worldTriangles(scene), worldTriangles(sceneOf(asNodes())), 1e-6);
        const auto shadows = buildPlanePairs(scene, false);
        EXPECT_EQ(shadows[0], shadows[2]) << "one copy of records";
    }
}

TEST(Instances, ShareWhatIsWorthIt) {
    const auto batchesOf = [](int triangles, int places, InstanceChoice choice) {
        GltfBuilder gltf;
        const int mesh = gltf.addShape(book(triangles));
        for (int i = 0; i < places; ++i)
            gltf.addNode({{"mesh", mesh}, {"translation", {i, 0, 0}}});
        return flattenScene(parseGltf(gltf.glb(), "test.glb"), 0.0, {}, choice).batches.size();
    };
    EXPECT_EQ(batchesOf(300, 2, InstanceChoice::automatic), 2u);
    EXPECT_EQ(batchesOf(300, 2, InstanceChoice::repeated), 1u);
    EXPECT_EQ(batchesOf(300, 1, InstanceChoice::shared), 1u);
    EXPECT_EQ(batchesOf(12, 50, InstanceChoice::automatic), 1u);
    EXPECT_EQ(batchesOf(12, 50, InstanceChoice::shared), 50u);
}

TEST(Instances, ThatAreFlattenedAreRepeated) {
    Instances scene;
    scene.attributes()["SCALE"] = scene.gltf.addArray<float>({1, 1, 1, 2, 0, 2, 0, 0, 0}, 3);
    const Scene flat = sharedSceneOf(scene.gltf);
    EXPECT_EQ(flat.triangleCount(), 12u);
    EXPECT_EQ(flat.batches.size(), 2u);
    EXPECT_EQ(worldBounds(flat).high, worldBounds(sceneOf(scene.gltf)).high);
    for (const Batch& batch : flat.batches)
        EXPECT_NE(glm::determinant(glm::dmat3(batch.worldFromBatch)), 0.0);
}

TEST(Instances, ShareTheirMeshWithAnimatedNodes) {
    GltfBuilder gltf = asNodes();
    gltf.animate(0);
    const GltfDocument document = parseGltf(gltf.glb(), "test.glb");
    Scene scene = flattenScene(document, 0.0, {}, InstanceChoice::shared);
    EXPECT_EQ(firstOfGeometry(scene.batches), (std::vector<std::size_t>{0, 0, 0}));
    EXPECT_EQ(std::count_if(scene.batches.begin(), scene.batches.end(),
                            [](const Batch& batch) { return batch.node == 0; }),
              1);
    Scene repeats = flattenScene(document, 0.0, {}, InstanceChoice::repeated);
    Warnings warnings;
    const auto animation = readAnimation(document, warnings);
    ASSERT_TRUE(animation);
    for (Scene* of : {&scene, &repeats})
        place(*of, poseAt(*animation, *of, 0.7));
    expectSameTriangles(worldTriangles(scene), worldTriangles(repeats), 1e-6);
}

TEST(Instances, OfWhatDeformsAreRepeated) {
    GltfBuilder gltf = morphingBall(6, 6);
    gltf.addNode({{"mesh", 0}, {"translation", {9, 0, 0}}});
    gltf.addNode({{"mesh", 0}, {"translation", {18, 0, 0}}});
    const Scene scene = sharedSceneOf(gltf);
    const std::vector<std::size_t> first = firstOfGeometry(scene.batches);
    for (std::size_t i = 0; i < scene.batches.size(); ++i) {
        if (scene.batches[i].deforms()) {
            EXPECT_EQ(std::count(first.begin(), first.end(), i), 1);
        }
    }
    EXPECT_EQ(scene.triangleCount(),
              flattenScene(parseGltf(gltf.glb(), "test.glb"), 0.0, {}, InstanceChoice::repeated)
                  .triangleCount());
}

TEST(Instances, TakeNoMoreMemoryThanTheirMeshAndPlaces) {
    GltfBuilder gltf;
    gltf.useExtension("EXT_mesh_gpu_instancing");
    const std::vector<float> places(3 * 10'000, 1.0f);
    gltf.addNode({{"mesh", gltf.addShape(book(500))},
                  {"extensions", instancing({{"TRANSLATION", gltf.addArray(places, 3)}})}});
    ReadingLimits limits;
    limits.memoryBytes = 20'000'000;
    const GltfDocument document = parseGltf(gltf.glb(), "test.glb", limits);
    EXPECT_EQ(flattenScene(document, 0.0).triangleCount(), 5'000'000u);
    expectInputError([&] { flattenScene(document, 0.0, {}, InstanceChoice::repeated); },
                     {"nodes[0] takes", "the limit is 20000000"});
}

TEST(Instances, AreWeldedNoFartherThanTheToleranceInTheWorld) {
    GltfBuilder gltf;
    const int mesh = gltf.addShape(box(glm::vec3(0.01f)));
    gltf.addNode({{"mesh", mesh}, {"scale", {100, 100, 100}}});
    gltf.addNode({{"mesh", mesh}, {"translation", {5, 0, 0}}});
    const Scene scene = sharedSceneOf(gltf, 0.5);
    EXPECT_EQ(buildPlanePairs(scene, false)[0]->caps.size(), 12u) << "2 wide where it is large";
}

TEST(Instances, ArePackedOnce) {
    CasterSettings settings;
    settings.instances = InstanceChoice::shared;
    settings.casterError = 0.01;
    const Bytes asset = Instances().gltf.glb();
    for (const Encoding encoding : everyEncoding) {
        const Bytes packedAsset = packed(asset, encoding, settings);
        const GltfDocument document = parseGltf(packedAsset, "packed.glb");
        const Json& extension = *shadowExtensionOf(document.json);
        EXPECT_EQ(extension["batches"].size(), 1u);
        EXPECT_EQ(extension["instances"], "shared");
        const Shadows shadows = readBack(packedAsset);
        ASSERT_EQ(shadows.size(), 3u);
        EXPECT_EQ(shadows[0], shadows[2]);
        expectSameShadows(shadows, built(asset, settings));
    }
}

TEST(Instances, OfOlderFilesAreRepeated) {
    GlbParts parts(packed(Instances().gltf.glb(), Encoding::indexed));
    Json& extension = parts.json["extensions"][shadowExtensionName];
    extension.erase("instances");
    const auto header = readShadowHeader(parseGltf(parts.glb(), "old.glb"));
    ASSERT_TRUE(header);
    EXPECT_EQ(header->settings.instances, InstanceChoice::repeated);
    extension["instances"] = "often";
    expectInputError([&] { readShadowHeader(parseGltf(parts.glb(), "odd.glb")); },
                     {".instances", "'often'", "not known"});
}

TEST(Instances, MustAgreeAndBePlaces) {
    const char* const field = "nodes[0].extensions.EXT_mesh_gpu_instancing.attributes";
    Instances few;
    few.attributes()["SCALE"] = few.gltf.addArray<float>({1, 1, 1}, 3);
    few.expectRefused({field, "SCALE has 1 elements, but TRANSLATION has 3"});
    Instances noAccessor;
    noAccessor.attributes()["SCALE"] = 99;
    noAccessor.expectRefused({field, "SCALE is 99"});
    Instances text;
    text.attributes()["SCALE"] = "3";
    text.expectRefused({field, "SCALE is \"3\"", "whole number"});
    Instances integers;
    integers.attributes()["SCALE"] = integers.gltf.addArray<std::int16_t>(
        {1, 1, 1, 1, 1, 1, 1, 1, 1}, 3, {{"normalized", true}});
    integers.expectRefused({field, "componentType 5122", "must be VEC3 floats"});
    Instances zero;
    zero.attributes()["ROTATION"] =
        zero.gltf.addArray<float>({0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1}, 4);
    zero.expectRefused({field, "(0, 0, 0, 0) at element 1", "not a rotation"});
    Instances infinite;
    infinite.attributes()["TRANSLATION"] =
        infinite.gltf.addArray<float>({0, 0, 0, 0, INFINITY, 0, 0, 0, 0}, 3);
    infinite.expectRefused({field, "infinite value at element 1"});
}

} // namespace edgeshade::test
