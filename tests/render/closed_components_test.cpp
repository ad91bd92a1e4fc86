// Closed components count only their light-facing triangles where winding numbers allow it, and all
// triangles elsewhere (docs/method.md, C8 and C9): light and eye inside and outside, in the same
// and in different components, nested and self-intersecting ones.

#include "preprocess/volumes/plane_pair_data.hpp"
#include "tests/support/mask_case.hpp"
#include "tests/support/scene_builder.hpp"

#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::Case;
using test::expectRight;
using test::pointLight;
using test::SceneBuilder;
using test::sun;

const Camera corner{{5, 4, 6}, {0, 0.5, 0}, 50.0};

/// Whether all of the scene's casters except the floor are closed.
bool isClosedButTheFloor(const Scene& scene) {
    std::size_t open = 0;
    for (const auto& shadow : buildPlanePairs(scene, false))
        for (const ShadowCluster& cluster : shadow->clusters)
            open += cluster.closed ? 0 : cluster.caps.count;
    return open == 2;
}

SceneBuilder twoBoxes() {
    return SceneBuilder()
        .floor(6)
        .box({-1.5f, 0.5f, -1}, {0, 2, 0.5f})
        .box({1, 0.2f, 0}, {2, 1, 1});
}

/// A room: a box with a cavity, which is a box turned inside out; in it a stool.
SceneBuilder room() {
    return SceneBuilder()
        .floor(8, -0.5f)
        .box({-3, -0.2f, -3}, {3, 3, 3})
        .box({2.8f, 2.8f, 2.8f}, {-2.8f, 0, -2.8f})
        .box({-0.5f, 0.4f, -0.5f}, {0.5f, 0.8f, 0.5f});
}

/// A prism over a polygon that crosses itself: its two halves wind 1 and -1 times around their
/// contents.
SceneBuilder bow() {
    SceneBuilder builder = SceneBuilder().floor(6);
    const glm::vec2 corners[] = {{-1.5f, -1}, {1.5f, 1}, {1.5f, -1}, {-1.5f, 1}};
    const auto at = [&](int i, float y) {
        const glm::vec2& c = corners[i % 4];
        return glm::vec3(c.x, y, c.y);
    };
    constexpr float low = 0.6f, high = 1.4f;
    for (int i = 0; i < 4; ++i)
        builder.quad(at(i, low), at(i, high), at(i + 1, high), at(i + 1, low));
    for (const int i : {1, 2}) {
        builder.triangle(at(0, high), at(i + 1, high), at(i, high));
        builder.triangle(at(0, low), at(i, low), at(i + 1, low));
    }
    return builder;
}

} // namespace

TEST(ClosedComponents, LightAndEyeOutside) {
    ASSERT_TRUE(isClosedButTheFloor(twoBoxes().scene()));
    expectRight({twoBoxes().scene(), corner, pointLight({0.5, 4, 0.7})});
    expectRight({twoBoxes().scene(), corner, sun({0.5, 1, -0.3})});
}

TEST(ClosedComponents, TheLightInOneLightsNothingOutside) {
    const Case test{twoBoxes().scene(), corner, pointLight({-0.7, 1.2, -0.2})};
    expectRight(test);
    EXPECT_EQ(test::run(test).lit, 0);
}

TEST(ClosedComponents, TheEyeInOneSeesItDarkInside) {
    expectRight({twoBoxes().scene(),
                 {{-0.7, 1.2, -0.2}, {-0.1, 1.0, 0.1}, 70.0},
                 pointLight({0.5, 4, 0.7}),
                 0.01});
}

TEST(ClosedComponents, LightAndEyeInTheSameOne) {
    const auto scene = SceneBuilder()
                           .floor(6)
                           .box({-2, 0.5f, -2}, {2, 3, 2})
                           .box({-0.4f, 1, -0.4f}, {0.4f, 1.6f, 0.4f});
    ASSERT_TRUE(isClosedButTheFloor(scene.scene()));
    // Inside a solid box its faces are turned away from the light: everything but the box inside is
    // dark.
    expectRight(
        {scene.scene(), {{1.5, 2.4, 1.5}, {0, 1.2, 0}, 60.0}, pointLight({-1.2, 2.7, 1}), 0.01});
}

TEST(ClosedComponents, LightInOneEyeInAnother) {
    expectRight({twoBoxes().scene(),
                 {{1.5, 0.6, 0.5}, {-1, 0.6, 0.3}, 70.0},
                 pointLight({-0.7, 1.2, -0.2}),
                 0.01});
}

TEST(ClosedComponents, LightAndEyeInACavity) {
    ASSERT_TRUE(isClosedButTheFloor(room().scene()));
    expectRight(
        {room().scene(), {{2.4, 2.2, 2.4}, {0, 0.3, 0}, 70.0}, pointLight({-1, 2.4, 0.6}), 0.01});
}

TEST(ClosedComponents, EyeInACavityLightOutside) {
    expectRight(
        {room().scene(), {{2.4, 2.2, 2.4}, {0, 0.3, 0}, 70.0}, pointLight({0, 9, 0}), 0.01});
}

TEST(ClosedComponents, LightInACavityEyeOutside) {
    expectRight({room().scene(), {{6, 6, 8}, {0, 1, 0}, 50.0}, pointLight({-1, 2.4, 0.6})});
}

TEST(ClosedComponents, LightInTheWallOfARoom) {
    expectRight(
        {room().scene(), {{2.4, 2.2, 2.4}, {0, 0.3, 0}, 70.0}, pointLight({-2.9, 1, 0}), 0.01});
}

TEST(ClosedComponents, ThatCrossThemselves) {
    ASSERT_TRUE(isClosedButTheFloor(bow().scene()));
    expectRight({bow().scene(), corner, pointLight({0.3, 4, 0.7})});
    expectRight({bow().scene(), corner, sun({0.4, 1, 0.2})});
}

TEST(ClosedComponents, TheLightInEitherHalfOfOneThatCrossesItself) {
    for (const double x : {-1.0, 1.0})
        expectRight({bow().scene(), corner, pointLight({x, 1, 0.05})});
}

TEST(ClosedComponents, TheEyeInEitherHalfOfOneThatCrossesItself) {
    for (const double x : {-1.2, 1.2})
        expectRight(
            {bow().scene(), {{x, 1, 0.05}, {0, 0.9, 0.1}, 80.0}, pointLight({0.3, 4, 0.7}), 0.01});
}

} // namespace edgeshade
