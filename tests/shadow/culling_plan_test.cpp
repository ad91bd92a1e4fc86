// The plan for casters that a scene culls (docs/method.md, C39).

#include "src/shadow/plan/count_plan.hpp"
#include "tests/support/bounded_frame.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/placed_shadows.hpp"
#include "tests/support/scene_builder.hpp"

#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::pointLight;
using test::SceneBuilder;

/// The plan of all casters for an eye at (0, 0, 5) that looks at the origin.
CountPlan planOf(const SceneBuilder& builder, const glm::dvec3& light, bool culls = true,
                 const glm::dvec3& eye = {0, 0, 5}) {
    Scene scene = builder.scene();
    scene.culls = culls;
    FrameRequest request;
    request.frustum = frustumOf({eye, {0, 0, 0}, 60.0}, 1.0);
    request.width = request.height = 64;
    request.lights = {pointLight(light)};
    request.depth = {0.1, 1};
    const FrameView view = test::boundedFrame(scene, false, request);
    KeptSolids solids;
    CountPlan plan;
    planCount(test::placedShadows(scene), scene.materials, view, view.slices.front(), 0,
              {23, nullptr, &solids}, plan);
    return plan;
}

const ClusterPlan& onlyCluster(const CountPlan& plan) {
    EXPECT_EQ(plan.batches.front().volumes.drawn.size(), 1u);
    return plan.batches.front().volumes.drawn.front();
}

/// The caps that are drawn in place.
std::vector<VolumeDraw> culledCaps(const CountPlan& plan) {
    std::vector<VolumeDraw> draws;
    for (const VolumeDraw& draw : plan.draws.once)
        if (draw.culled) draws.push_back(draw);
    return draws;
}

SceneBuilder outwardBox() {
    return SceneBuilder().box({-1, -1, -1}, {1, 1, 1});
}

SceneBuilder inwardBox() {
    return SceneBuilder().box({1, 1, 1}, {-1, -1, -1});
}

Material doubleSided() {
    Material material;
    material.doubleSided = true;
    return material;
}

TEST(CullingPlan, NothingChangesWhereNothingIsCulled) {
    EXPECT_TRUE(culledCaps(planOf(inwardBox(), {3, 3, 3}, false)).empty());
    const SceneBuilder both = SceneBuilder().material(doubleSided()).box({1, 1, 1}, {-1, -1, -1});
    EXPECT_TRUE(culledCaps(planOf(both, {3, 3, 3})).empty());
    EXPECT_EQ(onlyCluster(planOf(both, {3, 3, 3})).counted, Counted::lightFacing);
}

TEST(CullingPlan, ASolidSeenFromOutsideHidesItsBacks) {
    const CountPlan plan = planOf(outwardBox(), {3, 3, 3});
    EXPECT_TRUE(culledCaps(plan).empty());
    EXPECT_EQ(onlyCluster(plan).counted, Counted::lightFacing);
}

TEST(CullingPlan, ARoomSeenFromOutsideCountsItsBacksWhereTheyAre) {
    const CountPlan plan = planOf(inwardBox(), {3, 3, 3});
    const auto draws = culledCaps(plan);
    ASSERT_EQ(draws.size(), 1u);
    EXPECT_FALSE(draws[0].zFail);
    EXPECT_EQ(draws[0].faces, CapFaces::front);
    EXPECT_EQ(draws[0].range.count, 12u);
    EXPECT_EQ(draws[0].counted, Counted::facingAway);
    EXPECT_EQ(draws[0].vertexRuns(), 36u);
    EXPECT_FALSE(onlyCluster(plan).zFail()) << "sides go without caps as before";
}

TEST(CullingPlan, ALampInTheRoomCountsInFullAndOneInASolidShadesAllOutside) {
    const CountPlan room = planOf(inwardBox(), {0.2, 0.3, 0.1});
    EXPECT_FALSE(room.fullyShadowed);
    EXPECT_EQ(onlyCluster(room).counted, Counted::all);
    EXPECT_EQ(culledCaps(room).size(), 1u);
    EXPECT_TRUE(planOf(outwardBox(), {0.2, 0.3, 0.1}).fullyShadowed);
}

TEST(CullingPlan, TheEyeInASolidSeesOutOfIt) {
    const glm::dvec3 eye(0.3, 0.2, 0.4);
    EXPECT_TRUE(planOf(outwardBox(), {3, 3, 3}, false, eye).fullyShadowed);
    const CountPlan plan = planOf(outwardBox(), {3, 3, 3}, true, eye);
    EXPECT_FALSE(plan.fullyShadowed);
    EXPECT_EQ(onlyCluster(plan).counted, Counted::all);
    EXPECT_EQ(culledCaps(plan).size(), 1u);
}

TEST(CullingPlan, OfSheetsOnlyThoseThatShowTheirBacks) {
    const auto beforeAWall = [](const glm::vec3& right) {
        return SceneBuilder()
            .quad(-right - glm::vec3(0, 1, 0), right - glm::vec3(0, 1, 0),
                  right + glm::vec3(0, 1, 0), glm::vec3(0, 1, 0) - right)
            .material(doubleSided())
            .box({-9, -9, -9}, {9, 9, 9});
    };
    const SceneBuilder towards = beforeAWall({1, 0, 0}), away = beforeAWall({-1, 0, 0});
    EXPECT_TRUE(culledCaps(planOf(towards, {3, 3, 3})).empty());
    EXPECT_EQ(culledCaps(planOf(away, {3, 3, 3})).size(), 1u);
    EXPECT_TRUE(culledCaps(planOf(away, {3, 3, 3}, true, {0, 0, -5})).empty());
}

TEST(CullingPlan, SingleSidedCastersComeFirstInTheirCluster) {
    SceneBuilder builder;
    builder.material(doubleSided()).quad({-1, -1, 0}, {-1, 1, 0}, {1, 1, 0}, {1, -1, 0});
    builder.material(Material()).quad({-1, -1, 0}, {1, -1, 0}, {1, -1, 1}, {-1, -1, 1});
    const Scene scene = builder.scene();
    const auto shadow = buildPlanePairs(scene, false).front();
    ASSERT_EQ(shadow->clusters.size(), 1u);
    EXPECT_EQ(shadow->clusters[0].caps.count, 4u);
    EXPECT_EQ(shadow->clusters[0].singleSided, 2u);
    for (const std::uint32_t cap : {0u, 1u})
        EXPECT_GE(shadow->capTriangles[cap], 2u);
}

std::vector<std::uint8_t> solidsOf(const SceneBuilder& builder) {
    return findSolids(*buildPlanePairs(builder.scene(), false).front());
}

TEST(Solids, AreClosedOutwardsAndDoNotCrossThemselves) {
    using Solids = std::vector<std::uint8_t>;
    EXPECT_EQ(solidsOf(outwardBox()), Solids{1});
    EXPECT_EQ(solidsOf(inwardBox()), Solids{0});
    EXPECT_EQ(solidsOf(SceneBuilder().material(doubleSided()).box({-1, -1, -1}, {1, 1, 1})),
              Solids{0});
    // Components may cross each other: each one hides its own backs.
    EXPECT_EQ(solidsOf(outwardBox().box({0, 0, 0}, {3, 2, 2})), Solids{1});
    // A cavity's surface is wound inwards.
    EXPECT_EQ(solidsOf(outwardBox().box({0.5f, 0.5f, 0.5f}, {-0.5f, -0.5f, -0.5f})), Solids{0});
    EXPECT_EQ(solidsOf(SceneBuilder().floor(2)), Solids{0});
    // A prism over a polygon that crosses itself.
    SceneBuilder bow;
    const glm::vec2 outline[] = {{-1.5f, -1}, {1.5f, 1}, {1.5f, -1}, {-0.5f, 1}};
    const auto at = [&](int i, float y) {
        return glm::vec3(outline[i % 4].x, y, outline[i % 4].y);
    };
    for (int i = 0; i < 4; ++i)
        bow.quad(at(i, 0), at(i, 1), at(i + 1, 1), at(i + 1, 0));
    for (const int i : {1, 2}) {
        bow.triangle(at(0, 1), at(i + 1, 1), at(i, 1));
        bow.triangle(at(0, 0), at(i, 0), at(i + 1, 0));
    }
    EXPECT_EQ(solidsOf(bow), Solids{0});
}

} // namespace
} // namespace edgeshade
