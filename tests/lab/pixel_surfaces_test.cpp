// Areas of the surfaces that pixels show, and what a point sees.
#include "src/lab/pixel_surfaces.hpp"
#include "src/lab/sun_probe.hpp"
#include "src/shadow/view/plan_view.hpp"
#include "tests/support/scene_builder.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <numeric>

namespace edgeshade::lab {
namespace {

double areaSeen(const Scene& scene, const Frustum& frustum, int width, int height) {
    Question question;
    question.scene = &scene;
    question.frustum = standingBack(frustum, worldBounds(scene));
    question.width = width;
    question.height = height;
    const Oracle oracle(question, {});
    double area = 0.0;
    for (const PixelSurface& pixel : pixelSurfaces(oracle, {}))
        area += pixel.area;
    return area;
}

/// `camera`: the position of the oracle's camera, which must not matter.
bool sees(const Scene& scene, const glm::dvec3& point, const std::optional<glm::dvec3>& normal,
          const glm::dvec3& direction, const glm::dvec3& camera = glm::dvec3(3.0, 20.0, -1.0)) {
    Question question;
    question.scene = &scene;
    question.frustum.viewFromWorld = glm::translate(glm::dmat4(1.0), -camera);
    return seenFrom(Oracle(question, {}), point, normal, {&direction, 1}).front();
}

} // namespace

TEST(PixelSurfaces, AreAsLargeAsWhatIsSeen) {
    // A floor of 10 x 10, from straight above, from the side, and in perspective.
    const Scene floor = test::SceneBuilder().floor(5.0f).scene();
    EXPECT_NEAR(areaSeen(floor, planView(floor, 1.5, 0.0), 300, 200), 100.0, 1.0);
    EXPECT_NEAR(areaSeen(floor, planView(floor, 1.0, 30.0), 200, 200), 100.0, 1.0);
    const Camera aside{{9.0, 6.0, 12.0}, {0.0, 0.0, 0.0}, 60.0};
    EXPECT_NEAR(areaSeen(floor, frustumOf(aside, 1.0), 300, 300), 100.0, 1.0);
    EXPECT_NEAR(areaSeen(floor, frustumOf(aside, 1.0, 16.0), 300, 300), 100.0, 1.0);
    const Camera close{{0.0, 4.0, 8.0}, {0.0, 0.0, 0.0}, 100.0};
    EXPECT_NEAR(areaSeen(floor, frustumOf(close, 1.3), 390, 300), 100.0, 1.0);
}

TEST(PixelSurfaces, GrazingOnesDoNotGrowForEver) {
    const Scene wall =
        test::SceneBuilder().quad({0, 0, 0}, {0, 0, 1}, {1e-7f, 1, 1}, {1e-7f, 1, 0}).scene();
    Question question;
    question.scene = &wall;
    question.frustum = planView(wall, 1.0, 0.0);
    const rays::SurfaceTriangle triangle =
        rays::surfaceTriangles(wall, question.frustum, false, false).front();
    const PixelRay ray = pixelRay(question, 0.5, 0.5);
    const glm::dvec2 size = question.frustum.size();
    EXPECT_NEAR(footprintArea(question, triangle, ray, 1.0), size.x * size.y / leastCosine,
                1e-9 * size.x * size.y / leastCosine);
}

TEST(PlanView, HasNorthUp) {
    const Scene scene =
        test::SceneBuilder().floor(2.0f).box({3.0f, 0.0f, -1.0f}, {4.0f, 5.0f, 1.0f}).scene();
    for (const double north : {0.0, 90.0, -37.0}) {
        const Frustum plan = planView(scene, 1.6, north);
        const double turn = glm::radians(north);
        const glm::dvec3 up(std::sin(turn), 0.0, -std::cos(turn));
        EXPECT_NEAR((glm::dmat3(plan.viewFromWorld) * up).y, 1.0, 1e-12);
        EXPECT_NEAR(plan.forward().y, -1.0, 1e-12);
        for (const glm::vec3& position : scene.batches[0].geometry->positions) {
            const glm::dvec4 seen = plan.viewFromWorld * glm::dvec4(position, 1.0);
            EXPECT_LT(std::abs(seen.x), plan.high.x);
            EXPECT_LT(std::abs(seen.y), plan.high.y);
            EXPECT_LE(seen.z, 1e-9);
        }
    }
}

TEST(SunProbe, IsBlockedByCastersOnTheWay) {
    const Scene scene = test::SceneBuilder().floor(5.0f).box({1, 0, -1}, {2, 3, 1}).scene();
    const glm::dvec3 up(0.0, 1.0, 0.0);
    // From 1 in front of a wall of 3: free above a slope of 3 : 1.
    EXPECT_FALSE(sees(scene, {0, 0, 0}, up, {1.0, 2.99, 0.0}));
    EXPECT_TRUE(sees(scene, {0, 0, 0}, up, {1.0, 3.01, 0.0}));
    EXPECT_TRUE(sees(scene, {0, 0, 0}, up, {-1.0, 0.01, 0.0}));
    EXPECT_FALSE(sees(scene, {0, 0, 0}, up, {-1.0, -0.01, 0.0})); // turned away
    // Inside the box, in the open air, below the floor.
    EXPECT_FALSE(sees(scene, {1.5, 1.0, 0.0}, {}, {0.3, 1.0, 0.2}));
    EXPECT_TRUE(sees(scene, {1.5, 4.0, 0.0}, {}, {0.3, 1.0, 0.2}));
    EXPECT_FALSE(sees(scene, {0.2, -0.5, 0.0}, {}, {0.3, 1.0, 0.2}));
}

TEST(SunProbe, IsNotBlockedByTheSurfaceItLiesOn) {
    const Scene scene =
        test::SceneBuilder().floor(5.0f, 0.1f).box({1.1f, 0.1f, -1}, {2.3f, 3.7f, 1}).scene();
    for (const double x : {0.1, 0.3, -0.7, 4.9, 0.0}) // decimals that aren't exact floats
        for (const double z : {0.3, -1.7, 0.0})       // (0, 0) lies on the floor's diagonal
            EXPECT_TRUE(sees(scene, {x, 0.1, z}, {}, {-0.001, 1.0, 0.002})) << x << " " << z;
    EXPECT_TRUE(sees(scene, {1.7, 3.7, 0.3}, glm::dvec3(0, 1, 0), {0.9, 0.2, 0.1}));
    EXPECT_TRUE(sees(scene, {1.1, 2.0, 0.3}, glm::dvec3(-1, 0, 0), {-0.9, 0.2, 0.1}));
    EXPECT_FALSE(sees(scene, {1.1, 2.0, 0.3}, {}, {0.9, 0.2, 0.1})); // through the box
}

TEST(SunProbe, DoesNotDependOnTheCamera) {
    const Scene scene = test::SceneBuilder().floor(5.0f).box({1, 0, -1}, {2, 3, 1}).scene();
    for (const glm::dvec3& camera :
         {glm::dvec3(0.0), glm::dvec3(0.3, 1e4, 0.1), glm::dvec3(1.5, 1.0, 0.0)}) {
        EXPECT_FALSE(sees(scene, {0, 0, 0}, {}, {1.0, 2.99, 0.0}, camera));
        EXPECT_TRUE(sees(scene, {0, 0, 0}, {}, {1.0, 3.01, 0.0}, camera));
        EXPECT_TRUE(sees(scene, {0.3, 0, 0.1}, {}, {-0.001, 1.0, 0.002}, camera));
    }
}

} // namespace edgeshade::lab
