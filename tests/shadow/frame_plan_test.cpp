// The contents of the list of draws for scenes that are simple enough to predict.
#include "src/shadow/plan/frame_plan.hpp"

#include "tests/support/bounded_frame.hpp"
#include "tests/support/placed_shadows.hpp"
#include "tests/support/scene_builder.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <numbers>

namespace edgeshade {
namespace {

using Records = VolumeDraw::Records;
using Shape = VolumeDraw::Shape;
using test::SceneBuilder;

const glm::vec4 atInfinity(0, 0, 0, 1);

/// A scene and its plan.
struct Planned {
    FrameView view;
    PotentialSilhouettes silhouettes{23};
    FramePlan frame;

    const LightPlan& light(std::size_t i) const { return frame.slices.front().lights[i]; }
    const CountPlan& count() const { return light(0).counts.front(); }
    const DrawList& draws() const { return count().draws; }
};

enum class Choice { all, potential };

/// Plans one slice. `change` changes the view; `groups`: how often the casters are counted.
std::unique_ptr<Planned> planned(const Scene& scene, const Camera& camera,
                                 const std::vector<Light>& lights,
                                 Choice choice = Choice::potential, bool castMasked = false,
                                 const std::function<void(FrameView&)>& change = {},
                                 std::size_t groups = 1) {
    auto result = std::make_unique<Planned>();
    DepthChoice depth;
    depth.near = 0.1;
    depth.slices = 1;
    result->view =
        test::boundedFrame(scene, castMasked, {frustumOf(camera, 1.0), 64, 64, lights, depth});
    if (change) change(result->view);
    const std::vector<PlacedShadow> casters = test::placedShadows(scene, castMasked);
    PlanSettings settings;
    if (choice == Choice::potential) settings.silhouettes = &result->silhouettes;
    result->silhouettes.beginFrame(nullptr);
    planFrame({.view = result->view,
               .open = {0, 0, 64, 64},
               .groupCount = [&](std::size_t light) { return light == 0 ? groups : 1; },
               .planCount =
                   [&](const DepthSlice& slice, std::size_t light, std::size_t, CountPlan& plan) {
                       planCount(casters, scene.materials, result->view, slice, light, settings,
                                 plan);
                   }},
              result->frame);
    return result;
}

bool hasCaps(const VolumeDraw& draw) {
    return draw.shape != Shape::sides;
}

/// Seen from its side, over a floor.
Scene boxOverFloor() {
    return SceneBuilder().floor(9).box({-1, 1, -1}, {1, 2, 1}).scene();
}
const Camera fromTheSide{{0, 3, 9}, {0, 1, 0}, 50.0};
const Light lampAbove{{0.3, 7, 0.2, 1}};

/// A ball of small triangles around (0, 5, 0), over a floor below the eye.
Scene ballOverFloor() {
    SceneBuilder builder;
    builder.floor(60, -10);
    constexpr int rows = 24, columns = 48;
    const auto at = [](int row, int column) {
        const double up = std::numbers::pi * row / rows;
        const double around = 2.0 * std::numbers::pi * (column % columns) / columns;
        const double across = row % rows == 0 ? 0.0 : std::sin(up);
        return glm::vec3(across * std::cos(around), 5.0 + std::cos(up), across * std::sin(around));
    };
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            if (row > 0)
                builder.triangle(at(row, column), at(row, column + 1), at(row + 1, column));
            if (row + 1 < rows)
                builder.triangle(at(row, column + 1), at(row + 1, column + 1), at(row + 1, column));
        }
    return builder.scene();
}
/// On the outline of the ball's shadow, looking down.
const Camera onItsOutline{{1.11, 0, 0}, {1.3, -1, 0.2}, 60.0};
const Light lampHighAbove{{0, 50, 0, 1}};

TEST(FramePlan, AClosedBoxIsSidesAloneThatEndBeyondWhatIsVisible) {
    const auto plan =
        planned(SceneBuilder().box({-1, 1, -1}, {1, 2, 1}).scene(), fromTheSide, {lampAbove});
    EXPECT_TRUE(plan->draws().twice.empty());
    ASSERT_FALSE(plan->draws().once.empty());
    for (const VolumeDraw& draw : plan->draws().once) {
        EXPECT_EQ(draw.shape, Shape::sides);
        EXPECT_EQ(draw.counted, Counted::lightFacing);
        EXPECT_EQ(draw.times, Times::once);
        EXPECT_FALSE(draw.zFail);
        EXPECT_NE(draw.end, atInfinity);
        EXPECT_EQ(draw.verticesPerRecord, 4);
        EXPECT_GT(draw.range.count, 0u);
    }
    EXPECT_EQ(plan->count().start.count(), 0);
    EXPECT_EQ(plan->count().start.cleared(), 0);
}

TEST(FramePlan, OfABoxTheFourEdgesThatTheLightGrazesAreListed) {
    // From straight above only the top face faces the light; its four edges are the outline.
    const auto plan = planned(SceneBuilder().box({-1, 1, -1}, {1, 2, 1}).scene(), fromTheSide,
                              {{{0.1, 7, 0.2, 1}}});
    ASSERT_EQ(plan->draws().once.size(), 1u);
    EXPECT_EQ(plan->draws().once[0].records, Records::certainPairs);
    EXPECT_EQ(plan->draws().once[0].range.count, 4u);
    EXPECT_EQ(plan->count().vertexRuns(), 16u);
    // The records are only the twelve edges of the box: diagonals are flat.
    const auto all = planned(SceneBuilder().box({-1, 1, -1}, {1, 2, 1}).scene(), fromTheSide,
                             {{{0.1, 7, 0.2, 1}}}, Choice::all);
    ASSERT_EQ(all->draws().once.size(), 1u);
    EXPECT_EQ(all->draws().once[0].records, Records::allPairs);
    EXPECT_EQ(all->draws().once[0].range.count, 12u);
    EXPECT_EQ(all->count().vertexRuns(), 48u);
}

TEST(FramePlan, TheRidgeOfAnOpenRoofCountsTwiceAndItsBorderOnce) {
    // The light is in front of one side and behind the other.
    const Scene roof = SceneBuilder()
                           .quad({-1, 1, -1}, {-1, 1, 1}, {0, 3, 1}, {0, 3, -1})
                           .quad({0, 3, -1}, {0, 3, 1}, {1, 1, 1}, {1, 1, -1})
                           .scene();
    const Light aside{{-9, 2, 0.3, 1}};
    const auto plan = planned(roof, fromTheSide, {aside});
    ASSERT_EQ(plan->draws().twice.size(), 1u);
    EXPECT_EQ(plan->draws().twice[0].records, Records::certainPairs);
    EXPECT_EQ(plan->draws().twice[0].range.count, 1u);
    EXPECT_EQ(plan->draws().twice[0].times, Times::twice);
    EXPECT_EQ(plan->draws().twice[0].counted, Counted::all);
    ASSERT_EQ(plan->draws().once.size(), 1u);
    EXPECT_EQ(plan->draws().once[0].records, Records::singles);
    EXPECT_EQ(plan->draws().once[0].range.count, 6u);
    EXPECT_EQ(plan->draws().once[0].times, Times::once);
    // Without a list it is unknown which pairs count how often.
    const auto all = planned(roof, fromTheSide, {aside}, Choice::all);
    ASSERT_EQ(all->draws().twice.size(), 1u);
    EXPECT_EQ(all->draws().twice[0].records, Records::allPairs);
    ASSERT_EQ(all->draws().once.size(), 2u);
    EXPECT_EQ(all->draws().once[0].records, Records::singles);
    EXPECT_EQ(all->draws().once[1].records, Records::allPairs);
}

TEST(FramePlan, ASunsSidesAreTrianglesWhereTheyEndAtInfinity) {
    // No visible geometry is known, so that the only end is the view's.
    const auto plan = planned(boxOverFloor(), fromTheSide, {{{0.3, 1, 0.2, 0}}}, Choice::potential,
                              false, [](FrameView& view) {
                                  view.visible = Box();
                                  view.farthestDepth = std::numeric_limits<double>::infinity();
                              });
    bool any = false;
    for (const VolumeDraw& draw : plan->draws().once) {
        EXPECT_EQ(draw.isTriangle(), draw.end == atInfinity);
        any = any || draw.isTriangle();
    }
    EXPECT_TRUE(any);
}

TEST(FramePlan, CapsAreFansWhereSilhouettesAreFewAndKnown) {
    const auto plan = planned(ballOverFloor(), onItsOutline, {lampHighAbove});
    const auto& once = plan->draws().once;
    const auto fans = std::count_if(
        once.begin(), once.end(), [](const VolumeDraw& draw) { return draw.shape == Shape::fans; });
    EXPECT_GT(fans, 0);
    for (const VolumeDraw& draw : once) {
        EXPECT_NE(draw.shape, Shape::caps);
        if (!hasCaps(draw)) continue;
        EXPECT_TRUE(draw.zFail);
        EXPECT_EQ(draw.faces, CapFaces::back) << "the ball is behind the eye, its shadow before it";
        EXPECT_EQ(draw.verticesPerRecord, 3);
        EXPECT_EQ(draw.counted, Counted::lightFacing);
        EXPECT_EQ(draw.end, atInfinity);
    }
}

TEST(FramePlan, CapsAreTrianglesWhereNoSilhouettesAreKnown) {
    const auto plan = planned(ballOverFloor(), onItsOutline, {lampHighAbove}, Choice::all);
    bool caps = false;
    for (const VolumeDraw& draw : plan->draws().once) {
        EXPECT_NE(draw.shape, Shape::fans);
        if (draw.shape != Shape::caps) continue;
        caps = true;
        EXPECT_EQ(draw.records, Records::caps);
        EXPECT_EQ(draw.faces, CapFaces::back);
        EXPECT_FALSE(draw.alphaTested);
    }
    EXPECT_TRUE(caps);
    const auto fewer = planned(ballOverFloor(), onItsOutline, {lampHighAbove});
    EXPECT_LT(4 * fewer->count().vertexRuns(), plan->count().vertexRuns());
}

TEST(FramePlan, CastersWithHolesTakeAlphaTestedCapsOfTheirMaterial) {
    Material leaves;
    leaves.alphaMode = AlphaMode::mask;
    const Scene scene = SceneBuilder()
                            .floor(9)
                            .material(leaves)
                            .quad({-1, 2, 1}, {1, 2, 1}, {1, 2, -1}, {-1, 2, -1})
                            .scene();
    const auto plan = planned(scene, fromTheSide, {lampAbove}, Choice::potential, true);
    std::size_t tested = 0;
    for (const VolumeDraw& draw : plan->draws().once) {
        if (draw.shape != Shape::caps || !draw.alphaTested) continue;
        ++tested;
        EXPECT_EQ(scene.materials[*draw.alphaTested].alphaMode, AlphaMode::mask);
        EXPECT_TRUE(draw.zFail);
        EXPECT_NE(draw.faces, CapFaces::back);
        // Front caps a second time, where casters have holes.
        EXPECT_EQ(draw.verticesPerRecord, draw.faces == CapFaces::both ? 9 : 6);
    }
    EXPECT_EQ(tested, 1u);
}

TEST(FramePlan, WithinASealedBoxNothingIsDrawnAndAllIsInShadow) {
    const Scene room = SceneBuilder().box({-9, -9, -9}, {9, 9, 9}).scene();
    const auto plan = planned(room, {{0, 0, 0}, {1, 0.2, 0.1}, 60.0}, {{{0, 40, 0, 1}}});
    EXPECT_TRUE(plan->count().fullyShadowed);
    EXPECT_TRUE(plan->draws().once.empty() && plan->draws().twice.empty());
    EXPECT_EQ(plan->count().start.cleared(), 1);
    EXPECT_EQ(plan->count().vertexRuns(), 0u);
    EXPECT_EQ(plan->frame.slices.front().start().cleared(), 1);
}

TEST(FramePlan, TheEyeInABoxsShadowStartsTheStencilAtOne) {
    const Scene scene = SceneBuilder().floor(9).box({-1, 4, -1}, {1, 5, 1}).scene();
    const auto plan = planned(scene, {{0, 2, 0}, {0.2, 0, 3}, 50.0}, {{{0, 40, 0, 1}}});
    EXPECT_EQ(plan->count().start.count(), 1);
    EXPECT_EQ(plan->frame.slices.front().start().cleared(), 1);
}

TEST(FramePlan, TheFirstLightThatReachesSomethingGoesWithAmbientLight) {
    Light farAway{{0, 3, 500, 1}, 1.0};
    const auto plan = planned(boxOverFloor(), fromTheSide, {farAway, lampAbove, lampAbove});
    EXPECT_TRUE(plan->light(0).reach.empty());
    EXPECT_TRUE(plan->light(0).counts.empty());
    EXPECT_EQ(plan->frame.slices.front().first, 1u);
    EXPECT_TRUE(plan->frame.slices.front().withAmbient);

    const auto second =
        planned(boxOverFloor(), fromTheSide, {lampAbove, lampAbove}, Choice::potential, false,
                [](FrameView& view) { view.lights[0].drawn = false; });
    EXPECT_EQ(second->frame.slices.front().first, 1u);

    const auto grouped = planned(boxOverFloor(), fromTheSide, {lampAbove, lampAbove},
                                 Choice::potential, false, {}, 3);
    EXPECT_EQ(grouped->light(0).counts.size(), 3u);
    EXPECT_TRUE(grouped->light(0).inGroups());
    EXPECT_EQ(grouped->frame.slices.front().first, 1u) << "groups need the picture's alpha";

    const auto mask = planned(boxOverFloor(), fromTheSide, {lampAbove, lampAbove},
                              Choice::potential, false, [](FrameView& view) { view.mask = true; });
    EXPECT_EQ(mask->frame.slices.front().lights.size(), 1u);
    EXPECT_EQ(mask->frame.slices.front().first, 0u);
    EXPECT_FALSE(mask->frame.slices.front().withAmbient);
}

TEST(StencilStart, IsHalvedWhereCountsAreDoubled) {
    const auto startOf = [](int count, bool doubled) {
        VolumePlan plan;
        plan.drawn.resize(2);
        plan.drawn[0].start = count - 3;
        plan.drawn[1].start = 3;
        StencilStart start;
        start.add(plan);
        if (doubled) start.setDoubled();
        return start;
    };
    EXPECT_EQ(startOf(5, false).cleared(), 5);
    EXPECT_FALSE(startOf(5, false).isOddWhenDoubled());
    EXPECT_EQ(startOf(5, true).cleared(), 2);
    EXPECT_TRUE(startOf(5, true).isOddWhenDoubled());
    EXPECT_EQ(startOf(4, true).cleared(), 2);
    EXPECT_FALSE(startOf(4, true).isOddWhenDoubled());
    // Counts are modulo 256, also below 0.
    EXPECT_EQ(startOf(-1, false).cleared(), 255);
    EXPECT_EQ(startOf(-1, true).cleared(), 127);
    EXPECT_TRUE(startOf(-1, true).isOddWhenDoubled());
    EXPECT_EQ(startOf(257, false).cleared(), 1);
}

} // namespace
} // namespace edgeshade
