#include "src/rivals/planar/largest_planes.hpp"
#include "tests/support/scene_builder.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::SceneBuilder;

double distanceTo(const SurfacePlane& plane, const glm::dvec3& point) {
    return std::abs(glm::dot(plane.plane, glm::dvec4(point, 1.0)));
}

TEST(LargestPlanes, AreTheLargestFirst) {
    // The box's top and bottom are 4 x 4, its four sides 4 x 1.
    const auto planes =
        largestPlanes(SceneBuilder().floor(5).box({-2, 1, -2}, {2, 2, 2}).scene(), 3);
    ASSERT_EQ(planes.size(), 3u);
    EXPECT_NEAR(planes[0].area, 100.0, 1e-6);
    EXPECT_NEAR(planes[0].share, 100.0 / 148.0, 1e-6);
    EXPECT_NEAR(planes[1].area, 16.0, 1e-6);
    EXPECT_NEAR(planes[2].area, 16.0, 1e-6);
    EXPECT_LT(distanceTo(planes[0], {3, 0, -4}), 1e-9);
    EXPECT_EQ(planes[0].triangles.size(), 2u);
}

TEST(LargestPlanes, FewerThanAskedForAreAll) {
    EXPECT_EQ(largestPlanes(SceneBuilder().box({0, 0, 0}, {1, 2, 3}).scene(), 64).size(), 6u);
    EXPECT_TRUE(largestPlanes(SceneBuilder().scene(), 4).empty());
}

// Tiles, some facing down, on a plane that is tilted, mirrored and far away.
TEST(LargestPlanes, TiltedTilesFarFromTheOriginAreOnePlane) {
    SceneBuilder builder;
    for (int i = -10; i < 10; ++i)
        for (int j = -10; j < 10; ++j) {
            const float x = 0.5f * static_cast<float>(i), z = 0.5f * static_cast<float>(j);
            const glm::vec3 a(x, 0, z), b(x, 0, z + 0.5f), c(x + 0.5f, 0, z + 0.5f),
                d(x + 0.5f, 0, z);
            if ((i + j) % 2 == 0)
                builder.quad(a, b, c, d);
            else
                builder.quad(d, c, b, a);
        }
    glm::dmat4 placed = glm::translate(glm::dmat4(1.0), {4e6, -3e6, 1e5});
    placed = glm::rotate(placed, 0.7, {0.3, 0.5, 0.8});
    placed = glm::scale(placed, {-2.0, 1.0, 1.0});
    const auto planes = largestPlanes(builder.placedBy(placed).scene(), 2);
    ASSERT_EQ(planes.size(), 1u);
    EXPECT_EQ(planes[0].triangles.size(), 800u);
    EXPECT_NEAR(planes[0].share, 1.0, 1e-9);
    EXPECT_LT(distanceTo(planes[0], glm::dvec3(placed * glm::dvec4(4.5, 0, -3, 1))), 1e-3);
}

// A tilted plane's vertices, rounded to floats, are off it by a few units; steps of a stair are
// not.
TEST(LargestPlanes, TellRoundingFromSteps) {
    SceneBuilder builder;
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), 0.61, {0.2, 0.9, 0.5});
    const auto at = [&](double x, double y, double z) {
        return glm::vec3(turn * glm::dvec4(x, y, z, 1.0));
    };
    for (int i = 0; i < 200; ++i) {
        const double x = 0.05 * i, step = i % 2 == 0 ? 0.0 : 0.01;
        builder.quad(at(x, step, 1), at(x + 0.05, step, 1), at(x + 0.05, step, -1),
                     at(x, step, -1));
    }
    const auto planes = largestPlanes(builder.scene(), 8);
    ASSERT_EQ(planes.size(), 2u);
    EXPECT_EQ(planes[0].triangles.size(), 200u);
    EXPECT_NEAR(planes[0].area, planes[1].area, 1e-4);
}

// Triangles smaller than the tolerance are near many planes, and define none.
TEST(LargestPlanes, TinyAndDegenerateTriangles) {
    SceneBuilder builder = SceneBuilder().floor(5);
    builder.triangle({0, 0, 0}, {1e-6f, 0, 0}, {0, 1e-6f, 0});      // stands
    builder.triangle({1, 0, 0}, {1 + 1e-3f, 0, 0}, {1, 0, -1e-3f}); // lies
    builder.triangle({0, 0, 0}, {1, 0, 0}, {2, 0, 0});
    builder.triangle({1, 1, 1}, {1, 1, 1}, {1, 1, 1});
    const auto planes = largestPlanes(builder.scene(), 1);
    ASSERT_EQ(planes.size(), 1u);
    std::vector<std::uint32_t> first;
    for (const PlaneTriangle& of : planes[0].triangles)
        first.push_back(of.firstIndex);
    EXPECT_EQ(first, (std::vector<std::uint32_t>{0, 3, 9}));
    EXPECT_TRUE(
        largestPlanes(SceneBuilder().triangle({0, 0, 0}, {1, 0, 0}, {2, 0, 0}).scene(), 3).empty());
}

TEST(LargestPlanes, LeaveOutWhatMovesAndWhatIsSeenThrough) {
    Material blend;
    blend.alphaMode = AlphaMode::blend;
    const Scene seenThrough = SceneBuilder()
                                  .floor(1)
                                  .material(blend)
                                  .quad({-5, 1, 5}, {5, 1, 5}, {5, 1, -5}, {-5, 1, -5})
                                  .scene();
    const auto planes = largestPlanes(seenThrough, 4);
    ASSERT_EQ(planes.size(), 1u);
    EXPECT_NEAR(planes[0].area, 4.0, 1e-6);
    Scene moving = SceneBuilder().floor(1).scene();
    moving.batches.front().node = 0;
    EXPECT_TRUE(largestPlanes(moving, 4).empty());
}

} // namespace
} // namespace edgeshade
