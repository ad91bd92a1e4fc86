#include "src/render/near_plane.hpp"
#include "tests/support/scene_builder.hpp"

#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::SceneBuilder;

constexpr Camera lookingAlongMinusZ{{0, 0, 0}, {0, 0, -1}, 90.0};

double depthOf(const SceneBuilder& builder) {
    return nearestVisibleDepth(builder.scene().batches[0], lookingAlongMinusZ, 1.0);
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
    // A floor 2 below the eye enters a picture of 90 degrees at depth 2, though it also runs
    // beneath and behind the eye.
    EXPECT_NEAR(depthOf(SceneBuilder().floor(100.0f, -2.0f)), 2.0, 0.01);
}

TEST(NearPlane, IsZeroForASurfaceThroughTheEye) {
    EXPECT_NEAR(depthOf(SceneBuilder().floor(100.0f, 0.0f)), 0.0, 1e-12);
}

TEST(NearPlane, StaysJustBeforeTheNearest) {
    const double near = fittedNear({5.0, 3.0}, 10.0);
    EXPECT_LT(near, 3.0);
    EXPECT_GT(near, 2.9);
}

TEST(NearPlane, IsNeverZero) {
    EXPECT_GT(fittedNear({0.0}, 10.0), 0.0);
    EXPECT_GT(fittedNear({}, 10.0), 0.0);
    EXPECT_GT(fittedNear({}, 0.0), 0.0);
}

} // namespace
} // namespace edgeshade
