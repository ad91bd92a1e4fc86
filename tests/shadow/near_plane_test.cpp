#include "src/shadow/view/frame_view.hpp"
#include "src/shadow/view/visible_depth.hpp"
#include "tests/support/scene_builder.hpp"

#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::SceneBuilder;

const Frustum lookingAlongMinusZ = frustumOf({{0, 0, 0}, {0, 0, -1}, 90.0}, 1.0);

VisiblePart partOf(const Scene& scene, const Frustum& frustum) {
    return visiblePart(scene, SceneTree(scene), frustum, false);
}

double depthOf(const SceneBuilder& builder) {
    return partOf(builder.scene(), lookingAlongMinusZ).depth.nearest;
}

TEST(NearPlane, IsTheDepthOfAQuadAhead) {
    const auto ahead = SceneBuilder().quad({-1, -1, -5}, {1, -1, -5}, {1, 1, -5}, {-1, 1, -5});
    EXPECT_NEAR(depthOf(ahead), 5.0, 1e-6);
}

TEST(NearPlane, IgnoresWhatIsBesideThePicture) {
    // At depth 1 the picture ends at x = 1.
    const auto beside = SceneBuilder().quad({2, -1, -1}, {3, -1, -1}, {3, 1, -1}, {2, 1, -1});
    EXPECT_TRUE(std::isinf(depthOf(beside)));
}

TEST(NearPlane, IgnoresWhatIsBehind) {
    const auto behind = SceneBuilder().quad({-1, -1, 5}, {1, -1, 5}, {1, 1, 5}, {-1, 1, 5});
    EXPECT_TRUE(std::isinf(depthOf(behind)));
}

TEST(NearPlane, ClipsAFloorToThePicture) {
    // A floor 2 below the eye enters a picture of 90 degrees at depth 2, though it also extends
    // beneath and behind the eye.
    EXPECT_NEAR(depthOf(SceneBuilder().floor(100.0f, -2.0f)), 2.0, 0.01);
}

TEST(NearPlane, IsZeroForASurfaceThroughTheEye) {
    EXPECT_NEAR(depthOf(SceneBuilder().floor(100.0f, 0.0f)), 0.0, 1e-12);
}

TEST(NearPlane, StaysJustBeforeTheNearest) {
    EXPECT_LT(fittedNear(3.0, 10.0), 3.0);
    EXPECT_GT(fittedNear(3.0, 10.0), 2.9);
}

TEST(NearPlane, IsNeverZero) {
    EXPECT_GT(fittedNear(0.0, 10.0), 0.0);
    EXPECT_GT(fittedNear(INFINITY, 10.0), 0.0);
    EXPECT_GT(fittedNear(INFINITY, 0.0), 0.0);
}

TEST(VisibleDepth, EndsAtTheFarthest) {
    const auto two = SceneBuilder()
                         .quad({-1, -1, -5}, {1, -1, -5}, {1, 1, -5}, {-1, 1, -5})
                         .quad({-1, -1, -9}, {1, -1, -9}, {1, 1, -9}, {-1, 1, -9});
    const DepthRange range = partOf(two.scene(), lookingAlongMinusZ).depth;
    EXPECT_NEAR(range.nearest, 5.0, 1e-6);
    EXPECT_NEAR(range.farthest, 9.0, 1e-6);
}

std::vector<DepthSlice> divided(double near, double farthest, std::optional<int> count) {
    std::vector<DepthSlice> slices;
    divideDepth(near, farthest, count, slices);
    return slices;
}

TEST(DepthSlices, ShareTheRatioAndMeetEachOther) {
    const auto slices = divided(1.0, 1000.0, 3);
    ASSERT_EQ(slices.size(), 3u);
    EXPECT_TRUE(std::isinf(slices[0].far));
    EXPECT_NEAR(slices[0].near, 100.0, 1e-9);
    EXPECT_EQ(slices[1].far, slices[0].near);
    EXPECT_NEAR(slices[1].near, 10.0, 1e-9);
    EXPECT_EQ(slices[2].far, slices[1].near);
    EXPECT_NEAR(slices[2].near, 1.0, 1e-12);
}

TEST(DepthSlices, OneIsEnoughForAShallowView) {
    EXPECT_EQ(divided(1.0, 5.0, std::nullopt).size(), 1u);
    EXPECT_EQ(divided(1.0, 0.0, std::nullopt).size(), 1u); // nothing visible
}

} // namespace
} // namespace edgeshade
