// Records of deforming meshes: the same topology, the pose's planes, and a chain that stays closed.
#include "preprocess/gltf/gltf_reading.hpp"
#include "preprocess/reading/flatten.hpp"
#include "preprocess/scene/posing.hpp"
#include "preprocess/volumes/clustering.hpp"
#include "preprocess/volumes/triangle_planes.hpp"
#include "tests/support/moving_scenes.hpp"
#include "tests/support/posed_chain.hpp"

#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

/// A scene's deforming batches, with their records at rest.
struct Deforming {
    Scene scene;
    std::vector<std::pair<Batch*, PlanePairShadow>> batches;

    explicit Deforming(const GltfBuilder& gltf)
        : scene(flattenScene(parseGltf(gltf.glb(), "test.glb"), 0.0)) {
        for (Batch& batch : scene.batches)
            if (batch.deforms())
                batches.emplace_back(&batch,
                                     buildPlanePairs(batch, castersOf(batch, scene.materials, true),
                                                     scene.materials, 0.0));
    }
};

/// Expects caps in the places of the surfaces' triangles.
void expectCornersOfSurfaces(const PlanePairShadow& posed, const Batch& batch,
                             const std::vector<Material>& materials) {
    const Casters casters = castersOf(batch, materials, true);
    const CasterMesh mesh = weldForRecords(batch, casters);
    ASSERT_EQ(posed.caps.size(), mesh.welded.triangles.size());
    for (std::size_t i = 0; i < posed.caps.size(); ++i) {
        const std::size_t of = 3 * mesh.welded.source[posed.capTriangles[i]];
        EXPECT_EQ(posed.caps[i].a, batch.geometry->positions[casters.indices[of]]);
        EXPECT_EQ(posed.caps[i].b, batch.geometry->positions[casters.indices[of + 1]]);
        EXPECT_EQ(posed.caps[i].c, batch.geometry->positions[casters.indices[of + 2]]);
    }
}

std::vector<glm::vec4> lightsFor(const Batch& batch, Random& random, int count) {
    std::vector<glm::vec4> lights = {{0, 1, 0, 0}, {0.3f, 0.8f, 0.4f, 0}, {0, 3, 0, 1}};
    for (int i = 0; i < count; ++i) { // also at vertices
        const auto v = static_cast<std::size_t>(
            random.below(static_cast<int>(batch.geometry->positions.size())));
        lights.emplace_back(batch.geometry->positions[v], 1.0f);
        lights.emplace_back(glm::vec3(3.0 * random.inCube()), i % 2);
    }
    return lights;
}

} // namespace

TEST(PosedPlanePairs, HalfOfTheFiguresEdgesHaveTwoTrianglesAndAllAreClosed) {
    const Deforming figure(walkingFigure(8, 10));
    ASSERT_EQ(figure.batches.size(), 1u);
    const PlanePairShadow& shadow = figure.batches[0].second;
    EXPECT_EQ(shadow.caps.size(), 12u * 8u * 10u);
    EXPECT_EQ(shadow.pairs.size(), 3u * shadow.caps.size() / 2u);
    EXPECT_TRUE(shadow.singles.empty());
    for (const ShadowCluster& cluster : shadow.clusters)
        EXPECT_TRUE(cluster.closed);
}

TEST(PosedPlanePairs, FlatPairsStay) {
    // A flag that is flat at rest: no edge may be dropped, since it may wave.
    GltfBuilder gltf = morphingBall(4, 4);
    gltf.json["nodes"].back()["weights"] = {0, 0};
    const Deforming flag(gltf);
    for (const auto& [batch, shadow] : flag.batches) {
        EXPECT_EQ(shadow.flatPairs, 0u);
        EXPECT_EQ(shadow.flatEdges, 0u);
    }
    EXPECT_EQ(flag.batches.back().second.singles.size(), 2u * (10u + 6u)) << "its border";
}

TEST(PosedPlanePairs, AtRestNothingChanges) {
    for (const GltfBuilder& gltf : {walkingFigure(8, 10), morphingBall(8, 10)})
        for (const auto& [batch, shadow] : Deforming(gltf).batches) {
            const PlanePairShadow posed = posedPlanePairs(shadow, *batch);
            ASSERT_EQ(posed.pairs.size(), shadow.pairs.size());
            for (std::size_t i = 0; i < posed.pairs.size(); ++i) {
                EXPECT_EQ(posed.pairs[i].a, shadow.pairs[i].a);
                EXPECT_EQ(posed.pairs[i].plane0, shadow.pairs[i].plane0);
                EXPECT_EQ(posed.pairs[i].plane1, shadow.pairs[i].plane1);
            }
            for (std::size_t i = 0; i < posed.singles.size(); ++i)
                EXPECT_EQ(posed.singles[i].plane, shadow.singles[i].plane);
            for (std::size_t i = 0; i < posed.clusters.size(); ++i)
                EXPECT_EQ(posed.clusters[i].bounds.high, shadow.clusters[i].bounds.high);
            for (std::size_t i = 0; i < posed.leaves.size(); ++i)
                EXPECT_EQ(posed.leaves[i].low, shadow.leaves[i].low);
        }
}

TEST(PosedPlanePairs, PlanesAndBoxesAreThePoses) {
    Random random(11);
    Deforming ball(morphingBall(6, 8));
    for (auto& [batch, shadow] : ball.batches)
        for (int pose = 0; pose < 10; ++pose) {
            ASSERT_TRUE(poseBatch(*batch, randomShape(*batch, random, 0.3)));
            const PlanePairShadow posed = posedPlanePairs(shadow, *batch);
            for (const CapRecord& cap : posed.caps)
                EXPECT_EQ(cap.plane, trianglePlane(cap.a, cap.b, cap.c));
            for (const ShadowCluster& cluster : posed.clusters)
                for (std::uint32_t i = 0; i < cluster.caps.count; ++i) {
                    const CapRecord& cap = posed.caps[cluster.caps.first + i];
                    const Box& leaf = posed.leaves[cluster.leaves.first + i / leafTriangles];
                    for (const glm::vec3& corner : {cap.a, cap.b, cap.c})
                        for (const Box* box : {&cluster.bounds, &leaf})
                            for (glm::length_t c = 0; c < 3; ++c) {
                                EXPECT_LE(box->low[c], corner[c]);
                                EXPECT_GE(box->high[c], corner[c]);
                            }
                }
            expectCornersOfSurfaces(posed, *batch, ball.scene.materials);
        }
}

TEST(PosedPlanePairs, WhatTouchesAtRestComesApart) {
    // Two triangles with a common edge; a target moves one of them away.
    GltfBuilder gltf;
    Shape shape;
    shape.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}};
    shape.normals.assign(6, {0, 0, 1});
    shape.indices = {0, 1, 2, 3, 4, 5};
    Json primitive = gltf.primitiveOf(shape);
    primitive["targets"] = {
        {{"POSITION", gltf.addVectors(std::vector<glm::vec3>{
                          {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}})}}};
    const int node = gltf.addNode({{"mesh", gltf.addMesh(primitive)}});
    gltf.json["animations"] = {
        {{"channels", {{{"sampler", 0}, {"target", {{"node", node}, {"path", "weights"}}}}}},
         {"samplers",
          {{{"input", gltf.addArray<float>({0, 1}, 1, {{"min", {0.0}}, {"max", {1.0}}})},
            {"output", gltf.addArray<float>({0, 1}, 1)}}}}}};
    Deforming torn(gltf);
    ASSERT_EQ(torn.batches.size(), 1u);
    auto& [batch, shadow] = torn.batches[0];
    EXPECT_TRUE(shadow.pairs.empty());
    EXPECT_EQ(shadow.singles.size(), 6u) << "two triangles, each with a border of its own";
    BatchShape shape1 = batch->shape;
    shape1.weights[0][0] = 1.0;
    ASSERT_TRUE(poseBatch(*batch, shape1));
    expectCornersOfSurfaces(posedPlanePairs(shadow, *batch), *batch, torn.scene.materials);
}

TEST(PosedPlanePairs, StayClosedInRandomPosesWildOnesToo) {
    Random random(7);
    std::size_t checked = 0, degenerate = 0;
    for (const GltfBuilder& gltf : {walkingFigure(6, 8), morphingBall(8, 10)}) {
        Deforming deforming(gltf);
        for (auto& [batch, shadow] : deforming.batches)
            for (int pose = 0; pose < 100; ++pose) {
                ASSERT_TRUE(poseBatch(*batch, randomShape(*batch, random, 0.01 * pose)));
                const PlanePairShadow posed = posedPlanePairs(shadow, *batch);
                for (const CapRecord& cap : posed.caps)
                    degenerate += cap.plane == glm::vec4(0.0f);
                for (const glm::vec4& light : lightsFor(*batch, random, 4)) {
                    for (const glm::vec2& counted : {countAll, countLightFacing}) {
                        if (counted == countLightFacing && !posed.singles.empty()) continue;
                        checked += posed.pairs.size();
                        ASSERT_EQ(openEdgesOfPose(posed, signsOf(posed, light, counted)), 0u)
                            << "pose " << pose;
                    }
                }
            }
    }
    std::cout << "[ closed chain ] deforming: " << checked << " record-light pairs, " << degenerate
              << " triangles without area\n";
    EXPECT_GT(degenerate, 100u) << "poses are wild";
}

TEST(PosedPlanePairs, APlaneOfAnotherPoseOpensTheChainSoTheTestCanFail) {
    Random random(3);
    Deforming figure(walkingFigure(6, 8));
    auto& [batch, shadow] = figure.batches[0];
    ASSERT_TRUE(poseBatch(*batch, randomShape(*batch, random, 0.5)));
    PlanePairShadow posed = posedPlanePairs(shadow, *batch);
    for (std::size_t i = 0; i < posed.caps.size(); ++i)
        posed.caps[i].plane = shadow.caps[i].plane;
    EXPECT_GT(openEdgesOfPose(posed, signsOf(posed, {0.3f, 0.8f, 0.4f, 0}, countAll)), 0u);
}

} // namespace edgeshade::test
