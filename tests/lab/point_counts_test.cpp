// Counts of lit points against rays, and whether the comparison notices a fault.

#include "src/lab/point_counts.hpp"
#include "src/render/accumulation/extended_lights.hpp"
#include "src/render/frame/light_methods.hpp"
#include "src/render/frame/prepare_scene.hpp"
#include "tests/support/bounded_frame.hpp"
#include "tests/support/extended_lights.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/loaded_scene.hpp"
#include "tests/support/scene_builder.hpp"

#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::discTowards;
using test::panelAt;
using test::SceneBuilder;
using test::sphereAt;
using test::yard;

constexpr int width = 128, height = 96;
const lab::AlphaLookup opaque{[](auto&&...) { return 1.0f; }, {}};

struct Case {
    Scene scene;
    Camera camera;
    Light light;
    std::size_t points;
};

FrameView viewOf(const Case& test) {
    FrameRequest request{.frustum = frustumOf(test.camera, static_cast<double>(width) / height),
                         .width = width,
                         .height = height,
                         .lights = {test.light}};
    request.lightSamples = test.points;
    return test::boundedFrame(test.scene, false, request);
}

LitCounts drawn(const Case& test, ShadowMethod method) {
    const gl::HeadlessContext context({width, height});
    RenderSettings settings;
    settings.shadows = method;
    settings.layout = bestLayout(context.capabilities());
    const LoadedScene loaded = test::loadedOf(test.scene);
    GpuScene gpu = uploadScene(loaded, settings.records(), context.capabilities());
    Renderer renderer(settings, context.capabilities());
    const FrameView view = viewOf(test);
    prepareScene(gpu, loaded, view, renderer);
    if (method == ShadowMethod::primitiveMap) {
        const LightMethod made = lightMethods(gpu, view, renderer).front();
        EXPECT_EQ(made.method, "primitive-map") << made.why;
    }
    ExtendedLights lights(context.capabilities());
    lights.advance(renderer, gpu, loaded, view, test.points);
    gl::requireNoError("drawing a test scene");
    return lights.counts(0);
}

lab::PointOracle oracleOf(const Case& test) {
    const FrameView view = viewOf(test);
    return {{&test.scene, false, view.frustum, view.near(), lightPoints(test.light, test.points),
             width, height},
            opaque};
}

/// Checks the counts mask by mask, and by a primitive map for the whole light.
void expectRight(const Case& test, double mostPercent = 0.05) {
    lab::PointOracle oracle = oracleOf(test);
    for (const auto& [method, name] : {std::pair(ShadowMethod::volumes, "volumes"),
                                       std::pair(ShadowMethod::primitiveMap, "map")}) {
        SCOPED_TRACE(name);
        const lab::WrongSums sums = oracle.compare(drawn(test, method), test.points);
        EXPECT_GT(sums.visiblePixels, 1000u);
        EXPECT_EQ(sums.points, sums.visiblePixels * test.points);
        EXPECT_LE(sums.percent(), mostPercent);
        EXPECT_EQ(sums.beyond1pxNotTied, 0u);
    }
}

const Camera corner{{5, 4, 6}, {0, 0.5, 0}, 50.0};

TEST(PointCounts, SphereRectangleAndSun) {
    expectRight({yard().scene(), corner, sphereAt({0.3, 4, 0.7}, 0.5), 40});
    expectRight({yard().scene(), corner, panelAt({0.3, 4, 0.7}, {2, 1}, {0, -1, 0}), 40});
    expectRight({yard().scene(), corner, discTowards({0.5, 1, -0.3}, 6.0), 40});
}

TEST(PointCounts, ALampThatTouchesTheFloor) {
    expectRight({yard().scene(), corner, sphereAt({0.6, 0.3, 1.4}, 0.3), 40}, 0.2);
}

TEST(PointCounts, ALampHalfBuriedInAWall) {
    // Its centre is in the wall's plane, with half of its points behind.
    const Scene scene = SceneBuilder()
                            .floor(5)
                            .quad({-3, 0, -1}, {3, 0, -1}, {3, 3, -1}, {-3, 3, -1})
                            .box({-0.5f, 0, 0.2f}, {0.5f, 1, 1})
                            .scene();
    expectRight({scene, corner, sphereAt({0.2, 1.5, -1}, 0.4), 40}, 0.2);
}

TEST(PointCounts, ALampHalfBuriedInABox) {
    expectRight({SceneBuilder().floor(5).box({-1, 0, -1}, {1, 1, 1}).scene(), corner,
                 sphereAt({0.3, 1, 0.2}, 0.5), 40},
                0.2);
}

TEST(PointCounts, AnEyeWithinTheLamp) {
    expectRight({yard().scene(), corner, sphereAt(corner.from, 1.5), 40}, 0.1);
}

TEST(PointCounts, APanelThatLiesOnABox) {
    expectRight({SceneBuilder().floor(5).box({-1, 0, -1}, {1, 1, 1}).scene(), corner,
                 panelAt({0, 1, 0}, {3, 3}, {0, -1, 0}), 40},
                0.2);
}

TEST(PointCounts, ASunThatGrazesTheFloor) {
    // Half of its disc is below the horizon.
    expectRight({yard().scene(), corner, discTowards({1, 0.002, 0.4}, 4.0), 40}, 0.3);
}

TEST(PointCounts, FarFromTheOriginTinyAndHuge) {
    for (const double scale : {1e-3, 1e4}) {
        const glm::dmat4 place = glm::dmat4(glm::dmat3(scale));
        const Camera camera{scale * corner.from, scale * corner.to, 50.0};
        expectRight({yard().placedBy(place).scene(), camera,
                     sphereAt(scale * glm::dvec3(0.3, 4, 0.7), scale * 0.5), 20});
    }
    const glm::dvec3 far(4e6, 123.0, -5e6);
    glm::dmat4 place(1.0);
    place[3] = glm::dvec4(far, 1.0);
    expectRight({yard().placedBy(place).scene(),
                 {corner.from + far, corner.to + far, 50.0},
                 sphereAt(far + glm::dvec3(0.3, 4, 0.7), 0.5),
                 20});
}

TEST(PointCounts, FewerPointsAreComparedWithTheFirstOnes) {
    const Case many{yard().scene(), corner, sphereAt({0.3, 4, 0.7}, 0.5), 40};
    Case few = many;
    few.points = 9;
    lab::PointOracle oracle = oracleOf(many);
    EXPECT_LE(oracle.compare(drawn(few, ShadowMethod::volumes), 9).percent(), 0.05);
    EXPECT_GT(oracle.compare(drawn(few, ShadowMethod::volumes), 10).percent(), 1.0);
}

TEST(PointCounts, AFaultIsSeen) {
    const Case test{yard().scene(), corner, sphereAt({0.3, 4, 0.7}, 0.5), 16};
    lab::PointOracle oracle = oracleOf(test);
    LitCounts counts = drawn(test, ShadowMethod::volumes);
    const lab::WrongSums before = oracle.compare(counts, 16);
    std::size_t changed = 0;
    for (std::size_t i = 0; i < counts.lit.size() && changed < 5; i += 97)
        if (counts.lit[i] == 16) {
            counts.lit[i] = 3;
            ++changed;
        }
    ASSERT_EQ(changed, 5u);
    const lab::WrongSums after = oracle.compare(counts, 16);
    EXPECT_GE(after.wrong, before.wrong + 5 * 13 - 16);
    EXPECT_GE(after.wrongPixels, before.wrongPixels + 5);
    EXPECT_EQ(after.largest, 13u);
    EXPECT_GT(after.beyond1pxNotTied, 0u);
}

} // namespace
} // namespace edgeshade
