#include "src/shadow/view/framing.hpp"
#include "src/shadow/view/frustum.hpp"
#include "tests/support/scene_builder.hpp"

#include <gtest/gtest.h>
#include <random>

namespace edgeshade {
namespace {

/// Normalised device x and y of a world point.
glm::dvec2 project(const Camera& camera, double aspect, const glm::dvec3& point) {
    const glm::dvec4 clip = clipFromView(frustumOf(camera, aspect), 0.1) * viewFromWorld(camera) *
                            glm::dvec4(point, 1.0);
    return glm::dvec2(clip) / clip.w;
}

TEST(Camera, IsRightHandedWithYUp) {
    const Camera camera{{0, 0, 5}, {0, 0, 0}, 90.0};
    const glm::dvec2 right = project(camera, 2.0, {1, 0, 0});
    const glm::dvec2 up = project(camera, 2.0, {0, 1, 0});
    EXPECT_NEAR(right.x, 0.1, 1e-12); // 1 / (5 * tan 45 degrees * 2)
    EXPECT_NEAR(right.y, 0.0, 1e-12);
    EXPECT_NEAR(up.y, 0.2, 1e-12);
}

TEST(Camera, FovIsVertical) {
    const Camera camera{{0, 0, 1}, {0, 0, 0}, 60.0};
    const double edge = std::tan(glm::radians(30.0));
    EXPECT_NEAR(project(camera, 3.0, {0, edge, 0}).y, 1.0, 1e-12);
}

TEST(Camera, LookingDownHasMinusZUp) {
    const Camera camera{{0, 5, 0}, {0, 0, 0}, 45.0};
    EXPECT_GT(project(camera, 1.0, {0, 0, -1}).y, 0.0);
    EXPECT_GT(project(camera, 1.0, {1, 0, 0}).x, 0.0);
}

TEST(Camera, LookingUpHasMinusZUp) {
    const Camera camera{{0, 0, 0}, {0, 5, 0}, 45.0};
    EXPECT_GT(project(camera, 1.0, {0, 2, -1}).y, 0.0);
}

TEST(Camera, DirectionsLieOnTheFarPlaneBitForBit) {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    const auto vector = [&] { return glm::dvec3(normal(random), normal(random), normal(random)); };
    for (int i = 0; i < 10000; ++i) {
        const Camera camera{100.0 * vector(), vector(), 45.0};
        const glm::mat4 clip(clipFromView(frustumOf(camera, 1.5), 0.01) * viewFromWorld(camera));
        const glm::vec3 d(vector());
        const glm::vec4 far = clip[0] * d.x + clip[1] * d.y + clip[2] * d.z + clip[3] * 0.0f;
        ASSERT_EQ(far.z, far.w);
    }
}

TEST(Camera, FramingSeesEveryCornerOfTheBox) {
    for (const double aspect : {0.3, 1.0, 1.78, 5.0})
        for (const glm::dvec3 size :
             {glm::dvec3(1), glm::dvec3(100, 1, 1), glm::dvec3(1, 100, 1)}) {
            Box box;
            box.add(glm::dvec3(1e3));
            box.add(glm::dvec3(1e3) + size);
            const Camera camera = framingCamera(box, 45.0, aspect);
            for (int corner = 0; corner < 8; ++corner) {
                const glm::dvec3 point(corner & 1 ? box.high.x : box.low.x,
                                       corner & 2 ? box.high.y : box.low.y,
                                       corner & 4 ? box.high.z : box.low.z);
                const glm::dvec2 seen = project(camera, aspect, point);
                EXPECT_LE(std::abs(seen.x), 1.0);
                EXPECT_LE(std::abs(seen.y), 1.0);
            }
        }
}

TEST(Camera, FramingFillsThePictureWithWhatThereIs) {
    // A tower on a slab, from all around, for every shape of picture.
    const Scene scene = test::SceneBuilder()
                            .box({990, 5, 1000}, {1010, 6, 1010})
                            .box({1004, 6, 1003}, {1005, 21, 1004})
                            .scene();
    for (const double aspect : {0.3, 1.0, 1.78, 5.0})
        for (const glm::dvec3 from : {glm::dvec3(1, 1, 1), glm::dvec3(-1, 0.2, 0.1),
                                      glm::dvec3(0, 1, 0), glm::dvec3(0, -1, 0)}) {
            const Camera camera = framingCamera(scene, 45.0, aspect, glm::normalize(from));
            glm::dvec2 low(1e9), high(-1e9);
            for (const Batch& batch : scene.batches)
                for (const glm::vec3& position : batch.geometry->positions) {
                    const glm::dvec2 seen =
                        project(camera, aspect,
                                glm::dvec3(batch.worldFromBatch * glm::dvec4(position, 1.0)));
                    low = glm::min(low, seen);
                    high = glm::max(high, seen);
                }
            const glm::dvec2 size = high - low;
            EXPECT_GE(std::min(low.x, low.y), -0.96);
            EXPECT_LE(std::max(high.x, high.y), 0.96);
            EXPECT_GT(std::max(size.x, size.y), 1.85) << aspect; // of 2
        }
}

TEST(Camera, FramesAnEmptySceneToo) {
    const Camera nothing = framingCamera(Scene(), 45.0, 1.5);
    EXPECT_NE(nothing.from, nothing.to);
    const Camera camera = framingCamera(Box(), 45.0, 1.5);
    EXPECT_NE(camera.from, camera.to);
}

} // namespace
} // namespace edgeshade
