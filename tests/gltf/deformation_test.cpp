// Animated skins and morph targets, against plain arithmetic.
#include "preprocess/gltf/gltf_reading.hpp"
#include "preprocess/reading/animation_reading.hpp"
#include "preprocess/reading/flatten.hpp"
#include "preprocess/scene/posing.hpp"
#include "tests/support/hard_lights.hpp"
#include "tests/support/moving_scenes.hpp"
#include "tests/support/scene_triangles.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

/// The scene's only deforming batch.
Batch& deformingOf(Scene& scene) {
    Batch* found = nullptr;
    for (Batch& batch : scene.batches)
        if (batch.deforms()) {
            EXPECT_EQ(found, nullptr) << "there are two";
            found = &batch;
        }
    EXPECT_NE(found, nullptr);
    return *found;
}

/// A scene built in code, and its animations.
struct Moving {
    explicit Moving(const GltfBuilder& gltf)
        : document(parseGltf(gltf.glb(), "test.glb")), scene(flattenScene(document, 0.0)) {}

    std::vector<Placed> at(double seconds, std::optional<std::size_t> animation = {}) {
        const auto read = readAnimation(document, warnings, animation);
        EXPECT_TRUE(read);
        return place(scene, poseAt(*read, scene, seconds));
    }
    const Batch& deforming() { return deformingOf(scene); }
    std::size_t countOfDeforming() const {
        return static_cast<std::size_t>(
            std::count_if(scene.batches.begin(), scene.batches.end(),
                          [](const Batch& batch) { return batch.deforms(); }));
    }

    GltfDocument document;
    Scene scene;
    Warnings warnings;
};

int addTimes(GltfBuilder& gltf, const std::vector<float>& times) {
    return gltf.addArray(times, 1, {{"min", {times.front()}}, {"max", {times.back()}}});
}

/// Adds one channel, as an animation of its own.
void animate(GltfBuilder& gltf, int node, const std::string& path, const std::vector<float>& times,
             const Json& output, const std::string& interpolation = "LINEAR") {
    gltf.json["animations"].push_back(
        {{"channels", {{{"sampler", 0}, {"target", {{"node", node}, {"path", path}}}}}},
         {"samplers",
          {{{"input", addTimes(gltf, times)},
            {"output", output},
            {"interpolation", interpolation}}}}});
}

/// A tetrahedron with a target that moves corner 1 by (0, 4, 0) and one that moves corner 2 by (0,
/// 0, 2). Its weights go from (0, 1) to (1, 0) in 2 seconds, with this interpolation.
GltfBuilder morphing(const std::string& interpolation, const Json& node = Json::object()) {
    GltfBuilder gltf;
    Json primitive = gltf.primitiveOf(tetrahedron());
    primitive["targets"] = {
        {{"POSITION",
          gltf.addVectors(std::vector<glm::vec3>{{0, 0, 0}, {0, 4, 0}, {0, 0, 0}, {0, 0, 0}})}},
        {{"POSITION",
          gltf.addVectors(std::vector<glm::vec3>{{0, 0, 0}, {0, 0, 0}, {0, 0, 2}, {0, 0, 0}})}}};
    Json all = node;
    all["mesh"] = gltf.addMesh(primitive);
    const int index = gltf.addNode(all);
    const std::vector<float> plain = {0, 1, 1, 0};
    const std::vector<float> spline = {0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0};
    animate(gltf, index, "weights", {0, 2},
            gltf.addArray(interpolation == "CUBICSPLINE" ? spline : plain, 1), interpolation);
    return gltf;
}

/// The triangles of a tetrahedron with these corners.
std::vector<WorldTriangle> tetrahedronWith(const glm::vec3& corner1, const glm::vec3& corner2) {
    Shape shape = tetrahedron();
    shape.positions[1] = corner1;
    shape.positions[2] = corner2;
    GltfBuilder gltf;
    gltf.addShapeNode(shape);
    return worldTriangles(sceneOf(gltf));
}

/// A box whose upper half follows a joint that rotates about z by 90 degrees in 1 second, and moves
/// up by 2; its lower half follows a resting joint.
GltfBuilder bending(const Json& meshNode = Json::object()) {
    GltfBuilder gltf;
    const int upper = gltf.addNode({{"translation", {0, 1, 0}}}, false);
    const int lower = gltf.addNode({{"children", {upper}}});
    const std::vector<float> inverseBind = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0,  0, 1,
                                            1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1};
    gltf.json["skins"] = {
        {{"joints", {lower, upper}}, {"inverseBindMatrices", gltf.addArray(inverseBind, 16)}}};
    const Shape shape = box(glm::vec3(1.0f));
    Json primitive = gltf.primitiveOf(shape);
    std::vector<std::uint8_t> joints;
    std::vector<float> weights;
    for (const glm::vec3& position : shape.positions) {
        joints.insert(joints.end(), {static_cast<std::uint8_t>(position.y > 0 ? 1 : 0), 0, 0, 0});
        weights.insert(weights.end(), {1, 0, 0, 0});
    }
    primitive["attributes"]["JOINTS_0"] = gltf.addArray(joints, 4);
    primitive["attributes"]["WEIGHTS_0"] = gltf.addArray(weights, 4);
    Json node = meshNode;
    node["mesh"] = gltf.addMesh(primitive);
    node["skin"] = 0;
    gltf.addNode(node);
    const float root = std::sqrt(0.5f);
    const int times = addTimes(gltf, {0, 1});
    gltf.json["animations"] = {
        {{"name", "bend"},
         {"channels",
          {{{"sampler", 0}, {"target", {{"node", upper}, {"path", "rotation"}}}},
           {{"sampler", 1}, {"target", {{"node", upper}, {"path", "translation"}}}}}},
         {"samplers",
          {{{"input", times}, {"output", gltf.addArray<float>({0, 0, 0, 1, 0, 0, root, root}, 4)}},
           {{"input", times}, {"output", gltf.addArray<float>({0, 1, 0, 0, 3, 0}, 3)}}}}}};
    return gltf;
}

void expectNear(const glm::vec3& actual, const glm::vec3& expected, float tolerance = 1e-5f) {
    for (glm::length_t c = 0; c < 3; ++c)
        EXPECT_NEAR(actual[c], expected[c], tolerance) << "component " << c;
}

} // namespace

TEST(Deformation, WeightsMoveByLinesStepsAndSplines) {
    const auto cornersAt = [](const std::string& interpolation, double seconds) {
        Moving moving(morphing(interpolation));
        moving.at(seconds);
        return worldTriangles(moving.scene);
    };
    expectSameTriangles(cornersAt("LINEAR", 0.0), tetrahedronWith({1, 0, 0}, {0, 1, 2}), 1e-6);
    expectSameTriangles(cornersAt("LINEAR", 0.5), tetrahedronWith({1, 1, 0}, {0, 1, 1.5f}), 1e-6);
    expectSameTriangles(cornersAt("STEP", 1.9), tetrahedronWith({1, 0, 0}, {0, 1, 2}), 1e-6);
    expectSameTriangles(cornersAt("STEP", 2.0), tetrahedronWith({1, 4, 0}, {0, 1, 0}), 1e-6);
    // A Hermite cubic with flat ends at a quarter: 3/16 - 2/64 = 5/32.
    expectSameTriangles(cornersAt("CUBICSPLINE", 0.5),
                        tetrahedronWith({1, 4.0f * 5 / 32, 0}, {0, 1, 2.0f * 27 / 32}), 1e-6);
}

TEST(Deformation, AtRestWeightsOfTheNodeCountAndOfPosesTheOthersWeights) {
    Moving moving(morphing("LINEAR", {{"weights", {0.25, 0.5}}}));
    expectSameTriangles(worldTriangles(moving.scene), tetrahedronWith({1, 1, 0}, {0, 1, 1}), 1e-6);
    // Another animation leaves the weights unchanged.
    GltfBuilder other = morphing("LINEAR", {{"weights", {0.25, 0.5}}});
    animate(other, 0, "translation", {0}, other.addArray<float>({5, 0, 0}, 3));
    Moving both(other);
    both.at(0.0, 1);
    expectSameTriangles(
        worldTriangles(both.scene),
        [] {
            std::vector<WorldTriangle> all = tetrahedronWith({1, 1, 0}, {0, 1, 1});
            for (WorldTriangle& triangle : all)
                for (Corner& corner : triangle)
                    corner.position.x += 5.0;
            return all;
        }(),
        1e-6);
}

TEST(Deformation, WhatNoAnimationMovesIsStatic) {
    GltfBuilder still = morphing("LINEAR");
    still.json.erase("animations");
    EXPECT_EQ(Moving(still).countOfDeforming(), 0u);
    GltfBuilder bent = bending();
    bent.json.erase("animations");
    EXPECT_EQ(Moving(bent).countOfDeforming(), 0u);
    EXPECT_EQ(Moving(bending()).countOfDeforming(), 1u);
    EXPECT_TRUE(Moving(bending()).scene.warnings.sentences().empty());
}

TEST(Deformation, SkinsGoWithTheirJointsAndNormalsFollow) {
    Moving moving(bending({{"translation", {99, 0, 0}}})); // the mesh node's own transform does not
                                                           // count
    const std::vector<glm::vec3> rest = moving.deforming().geometry->positions;
    const std::vector<glm::vec3> restNormals = moving.deforming().geometry->normals;
    EXPECT_EQ(moving.at(1.0).back().reshaped, true);
    const Batch& bent = moving.deforming();
    ASSERT_EQ(bent.geometry->positions.size(), rest.size());
    for (std::size_t v = 0; v < rest.size(); ++v) {
        const glm::vec3 &p = rest[v], &n = restNormals[v];
        // About (0, 1, 0), which by then is at (0, 3, 0).
        const bool upper = p.y > 0;
        expectNear(bent.geometry->positions[v], upper ? glm::vec3(-(p.y - 1), p.x + 3, p.z) : p);
        expectNear(bent.geometry->normals[v], upper ? glm::vec3(-n.y, n.x, n.z) : n);
    }
}

TEST(Deformation, ThePoseAtRestIsTheSceneToTheLastBit) {
    for (const GltfBuilder& gltf : {bending(), walkingFigure(6, 8), morphingBall(6, 8)}) {
        Moving moving(gltf);
        const Scene rest = moving.scene;
        const std::vector<Placed> placed = place(moving.scene, poseAt({}, moving.scene, 0.0));
        for (std::size_t b = 0; b < rest.batches.size(); ++b) {
            EXPECT_FALSE(placed[b].reshaped);
            EXPECT_EQ(moving.scene.batches[b].geometry->positions,
                      rest.batches[b].geometry->positions);
        }
        // Back to the rest pose from another one.
        moving.at(0.3);
        place(moving.scene, poseAt({}, moving.scene, 0.0));
        for (std::size_t b = 0; b < rest.batches.size(); ++b)
            EXPECT_EQ(moving.scene.batches[b].geometry->positions,
                      rest.batches[b].geometry->positions);
    }
}

TEST(Deformation, FurtherSetsOfJointsCount) {
    GltfBuilder gltf = bending();
    Json& attributes = gltf.json["meshes"][0]["primitives"][0]["attributes"];
    const std::size_t count = box(glm::vec3(1.0f)).positions.size();
    std::vector<std::uint8_t> joints;
    std::vector<float> weights;
    for (std::size_t v = 0; v < count; ++v) { // the upper joint counts as much as all others
        joints.insert(joints.end(), {1, 0, 0, 0});
        weights.insert(weights.end(), {1, 0, 0, 0});
    }
    attributes["JOINTS_1"] = gltf.addArray(joints, 4);
    attributes["WEIGHTS_1"] = gltf.addArray(weights, 4);
    Moving moving(gltf);
    const std::vector<glm::vec3> rest = moving.deforming().geometry->positions;
    moving.at(1.0);
    for (std::size_t v = 0; v < rest.size(); ++v) {
        const glm::vec3& p = rest[v];
        const glm::vec3 turned(-(p.y - 1), p.x + 3, p.z);
        expectNear(moving.deforming().geometry->positions[v],
                   p.y > 0 ? turned : 0.5f * (p + turned));
    }
}

TEST(Deformation, VerticesAreAlikeWhereAllThatMovesThemIs) {
    Moving moving(bending());
    const Batch& batch = moving.deforming();
    const std::vector<std::uint32_t> alike = alikeVertices(batch);
    std::size_t distinct = 0;
    for (std::uint32_t v = 0; v < alike.size(); ++v) {
        EXPECT_EQ(batch.geometry->positions[alike[v]], batch.geometry->positions[v]);
        distinct += alike[v] == v;
    }
    EXPECT_EQ(distinct, 8u) << "of 24 vertices, three a corner";

    // Two halves at one place, on different joints, are not welded.
    GltfBuilder torn = bending();
    std::vector<std::uint8_t> joints(4 * alike.size(), 0);
    for (std::size_t v = 0; v < alike.size(); v += 2)
        joints[4 * v] = 1;
    torn.json["meshes"][0]["primitives"][0]["attributes"]["JOINTS_0"] = torn.addArray(joints, 4);
    Moving apart(torn);
    const std::vector<std::uint32_t> ofTorn = alikeVertices(apart.deforming());
    EXPECT_EQ(apart.deforming().geometry->positions.size(), 24u);
    for (std::uint32_t v = 0; v < ofTorn.size(); ++v)
        EXPECT_EQ(ofTorn[v] % 2, v % 2);
}

TEST(Deformation, AlikeVerticesStayTogetherInWildPoses) {
    Random random(5);
    for (const GltfBuilder& gltf : {walkingFigure(7, 9), morphingBall(7, 9)}) {
        Moving moving(gltf);
        for (Batch& batch : moving.scene.batches) {
            if (!batch.deforms()) continue;
            const std::vector<std::uint32_t> alike = alikeVertices(batch);
            for (int pose = 0; pose < 20; ++pose) {
                BatchShape shape = batch.shape;
                for (glm::dmat4& matrix : shape.batchFromMesh)
                    for (glm::length_t c = 0; c < 4; ++c)
                        matrix[c] += glm::dvec4(random.magnitude(-3, 3) * random.inCube(), 0.0);
                for (auto& weights : shape.weights)
                    for (double& weight : weights)
                        weight = random.uniform(-9, 9);
                ASSERT_TRUE(poseBatch(batch, shape));
                for (std::uint32_t v = 0; v < alike.size(); ++v)
                    ASSERT_EQ(batch.geometry->positions[alike[v]], batch.geometry->positions[v]);
            }
        }
    }
}

TEST(Deformation, APoseOutOfAllRangeIsNotDrawnAndChangesNothing) {
    GltfBuilder gltf = morphing("LINEAR");
    animate(gltf, 0, "weights", {0, 1}, gltf.addArray<float>({0, 0, 3e38f, 0}, 1));
    Moving moving(gltf);
    const std::vector<glm::vec3> rest = moving.deforming().geometry->positions;
    const std::vector<Placed> placed = moving.at(1.0, 1);
    EXPECT_FALSE(placed.back().visible);
    EXPECT_EQ(moving.deforming().geometry->positions, rest);
    EXPECT_TRUE(moving.at(0.5, 0).back().visible);
}

TEST(Deformation, AnimationsAreFoundByNameAndIndex) {
    const GltfDocument document = parseGltf(walkingFigure(3, 2).glb(), "test.glb");
    const std::vector<AnimationTitle> titles = animationTitles(document);
    ASSERT_EQ(titles.size(), 3u);
    EXPECT_EQ(titles[1].name, "wave");
    EXPECT_EQ(findAnimation(titles, "jump"), &titles[2]);
    EXPECT_EQ(findAnimation(titles, "1"), &titles[1]);
    EXPECT_EQ(findAnimation(titles, "3"), nullptr);
    EXPECT_EQ(findAnimation(titles, ""), nullptr);
    GltfBuilder unnamed = bending();
    unnamed.json["animations"][0]["name"] = 7;
    EXPECT_EQ(animationTitles(parseGltf(unnamed.glb(), "test.glb")).at(0).name, "animation 0");
}

TEST(Deformation, TheScenesThatShipAreTheAuthoredOnes) {
    const auto expectAlike = [](const char* name, const GltfBuilder& gltf) {
        const Scene ships =
            flattenScene(readGltf(std::filesystem::path(EDGESHADE_ASSETS) / name), 0.0);
        const Scene authored = sceneOf(gltf);
        ASSERT_EQ(ships.batches.size(), authored.batches.size());
        for (std::size_t b = 0; b < ships.batches.size(); ++b) {
            const std::vector<glm::vec3>&of = ships.batches[b].geometry->positions,
                  &wanted = authored.batches[b].geometry->positions;
            ASSERT_EQ(of.size(), wanted.size());
            for (std::size_t v = 0; v < of.size(); ++v)
                expectNear(of[v], wanted[v]);
        }
    };
    expectAlike("walking-figure.glb", walkingFigure(12, 12));
    expectAlike("morphing-ball.glb", morphingBall(20, 16));
}

namespace {

/// A tetrahedron on one joint, both below an armature that an animation scales from (1, 1, 1) to
/// `scale` within a second; its rest scale is `rest`.
GltfBuilder scaledArmature(const Json& rest, const std::vector<float>& scale) {
    GltfBuilder gltf;
    const int joint = gltf.addNode(Json::object(), false);
    gltf.json["skins"] = {{{"joints", Json::array({joint})}}};
    Json primitive = gltf.primitiveOf(tetrahedron());
    primitive["attributes"]["JOINTS_0"] = gltf.addArray(std::vector<std::uint8_t>(16, 0), 4);
    std::vector<float> weights(16, 0.0f);
    for (std::size_t i = 0; i < 16; i += 4)
        weights[i] = 1.0f;
    primitive["attributes"]["WEIGHTS_0"] = gltf.addArray(weights, 4);
    const int skinned = gltf.addNode({{"mesh", gltf.addMesh(primitive)}, {"skin", 0}}, false);
    const int armature = gltf.addNode({{"children", {joint, skinned}}, {"scale", rest}});
    std::vector<float> scales = {1, 1, 1};
    scales.insert(scales.end(), scale.begin(), scale.end());
    animate(gltf, armature, "scale", {0, 1}, gltf.addArray(scales, 3), "STEP");
    return gltf;
}

std::vector<WorldTriangle> scaledTetrahedron(const Json& scale) {
    GltfBuilder gltf;
    gltf.addNode({{"mesh", gltf.addShape(tetrahedron())}, {"scale", scale}});
    return worldTriangles(sceneOf(gltf));
}

} // namespace

TEST(Deformation, ASkinIsTurnedOverWhileItsNodeMirrors) {
    for (const Json& rest : {Json{1, 1, 1}, Json{-1, 1, 1}, Json{0, 0, 0}}) {
        Moving moving(scaledArmature(rest, {-1, 1, 1}));
        moving.at(1.0);
        EXPECT_TRUE(moving.deforming().isMirrored()) << rest;
        expectSameTriangles(worldTriangles(moving.scene), scaledTetrahedron({-1, 1, 1}), 1e-6);
        moving.at(0.0);
        EXPECT_FALSE(moving.deforming().isMirrored()) << rest;
        expectSameTriangles(worldTriangles(moving.scene), scaledTetrahedron({1, 1, 1}), 1e-6);
    }
    expectSameTriangles(worldTriangles(Moving(scaledArmature({-1, 1, 1}, {1, 1, 1})).scene),
                        scaledTetrahedron({-1, 1, 1}), 1e-6);
}

TEST(Deformation, MeshesOfOneSkinAreTurnedOverEachByItself) {
    GltfBuilder gltf = scaledArmature({1, 1, 1}, {-1, 1, 1});
    gltf.addNode({{"mesh", 0}, {"skin", 0}, {"scale", {-1, 1, 1}}});
    Moving moving(gltf);
    const auto mirrored = [&] {
        std::vector<bool> all;
        for (const Batch& batch : moving.scene.batches)
            if (batch.deforms()) all.push_back(batch.isMirrored());
        std::sort(all.begin(), all.end());
        return all;
    };
    EXPECT_EQ(mirrored(), (std::vector<bool>{false, true}));
    moving.at(1.0);
    EXPECT_EQ(mirrored(), (std::vector<bool>{true, true}));
}

TEST(Deformation, JointsScaledToNothingAtRestGrow) {
    Moving moving(scaledArmature({0, 0, 0}, {2, 2, 2}));
    EXPECT_TRUE(moving.scene.warnings.sentences().empty());
    for (const glm::vec3& position : moving.deforming().geometry->positions)
        EXPECT_EQ(position, glm::vec3(0.0f));
    moving.at(1.0);
    expectSameTriangles(worldTriangles(moving.scene), scaledTetrahedron({2, 2, 2}), 1e-6);
}

TEST(Deformation, WeightsThatDoNotFitLeaveTheAnimationOut) {
    GltfBuilder gltf = morphing("LINEAR");
    gltf.json["animations"][0]["samplers"][0]["output"] = gltf.addArray<float>({0, 1, 1}, 1);
    Moving moving(gltf);
    EXPECT_FALSE(readAnimation(moving.document, moving.warnings));
    ASSERT_EQ(moving.warnings.sentences().size(), 1u);
    EXPECT_NE(moving.warnings.sentences()[0].find("animations[0].samplers[0].output"),
              std::string::npos)
        << moving.warnings.sentences()[0];
    EXPECT_NE(moving.warnings.sentences()[0].find("2 weights"), std::string::npos);
}

} // namespace edgeshade::test
