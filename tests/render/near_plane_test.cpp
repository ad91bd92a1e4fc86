#include "src/shadow/view/frame_view.hpp"
#include "src/shadow/view/visible_depth.hpp"
#include "tests/support/scene_builder.hpp"

#include <gtest/gtest.h>
#include <random>

namespace edgeshade {
namespace {

using test::SceneBuilder;

const Frustum lookingAlongMinusZ = frustumOf({{0, 0, 0}, {0, 0, -1}, 90.0}, 1.0);

double depthOf(const SceneBuilder& builder) {
    return visiblePart(builder.scene(), builder.scene().batches[0], lookingAlongMinusZ)
        .depth.nearest;
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
    const VisiblePart part = visiblePart(two.scene(), two.scene().batches[0], lookingAlongMinusZ);
    const DepthRange& range = part.depth;
    EXPECT_NEAR(range.nearest, 5.0, 1e-6);
    EXPECT_NEAR(range.farthest, 9.0, 1e-6);
}

// Runs of triangles are tested first: those left out must add nothing.
TEST(VisibleDepth, IsThatOfAllTrianglesOneByOne) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
    const auto vector = [&] {
        const float x = unit(random), y = unit(random), z = unit(random);
        return glm::vec3(x, y, z);
    };
    for (const bool orthographic : {false, true})
        for (int i = 0; i < 8; ++i) {
            // Runs of small triangles with an occasional large one.
            SceneBuilder builder;
            for (int run = 0; run < 12; ++run) {
                const glm::vec3 at = 4.0f * vector() - glm::vec3(0, 0, 6);
                for (int t = 0; t < 70; ++t) {
                    const glm::vec3 middle = at + 0.5f * vector();
                    const float size = t % 50 == 49 ? 3.0f : 0.2f;
                    builder.triangle(middle + size * vector(), middle + size * vector(),
                                     middle + size * vector());
                }
            }
            const Scene scene = builder.scene();
            const Camera camera{{0.3 * i, -0.2, 1.0 - i}, {0.1, 0.1 * i, -6}, 70.0};
            const Frustum frustum =
                orthographic ? frustumOf(camera, 1.2, 6.0) : frustumOf(camera, 1.2);
            const VisiblePart all = visiblePart(scene, scene.batches[0], frustum);
            VisiblePart summed;
            const std::vector<std::uint32_t>& indices = scene.batches[0].geometry->indices;
            for (std::size_t t = 0; t < indices.size(); t += 3) {
                Scene one = scene;
                one.batches[0].geometry.edit().indices = {indices[t], indices[t + 1],
                                                          indices[t + 2]};
                summed.add(visiblePart(one, one.batches[0], frustum));
            }
            EXPECT_EQ(all.depth.nearest, summed.depth.nearest);
            EXPECT_EQ(all.depth.farthest, summed.depth.farthest);
            for (glm::length_t axis = 0; axis < 3; ++axis) {
                EXPECT_NEAR(all.box.low[axis], summed.box.low[axis], 1e-12);
                EXPECT_NEAR(all.box.high[axis], summed.box.high[axis], 1e-12);
            }
            EXPECT_EQ(all.slopes.right.low, summed.slopes.right.low);
            EXPECT_EQ(all.slopes.right.high, summed.slopes.right.high);
            EXPECT_EQ(all.slopes.up.low, summed.slopes.up.low);
            EXPECT_EQ(all.slopes.up.high, summed.slopes.up.high);
        }
}

TEST(DepthSlices, ShareTheRatioAndMeetEachOther) {
    const auto slices = divideDepth(1.0, 1000.0, 3);
    ASSERT_EQ(slices.size(), 3u);
    EXPECT_TRUE(std::isinf(slices[0].far));
    EXPECT_NEAR(slices[0].near, 100.0, 1e-9);
    EXPECT_EQ(slices[1].far, slices[0].near);
    EXPECT_NEAR(slices[1].near, 10.0, 1e-9);
    EXPECT_EQ(slices[2].far, slices[1].near);
    EXPECT_NEAR(slices[2].near, 1.0, 1e-12);
}

TEST(DepthSlices, OneIsEnoughForAShallowView) {
    EXPECT_EQ(divideDepth(1.0, 5.0, std::nullopt).size(), 1u);
    EXPECT_EQ(divideDepth(1.0, 0.0, std::nullopt).size(), 1u); // nothing visible
}

} // namespace
} // namespace edgeshade
