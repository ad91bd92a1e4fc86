// Dragging a handle moves the light to the pointer.

#include "src/viewer/light_handles.hpp"

#include <gtest/gtest.h>

namespace edgeshade::viewer {
namespace {

const PictureView view{{{3, 4, 10}, {0, 1, 0}, 45.0}, 800, 600};
const Box bounds{{-2, 0, -2}, {2, 3, 2}};
const LightHandles handles(bounds);

Light point(const glm::dvec3& at) {
    return {glm::dvec4(at, 1.0)};
}
Light sunTowards(const glm::dvec3& direction) {
    return {glm::dvec4(direction, 0.0)};
}

void expectHandleAt(const Light& light, const glm::dvec2& pixel) {
    const auto at = handles.pixelOf(light, view);
    ASSERT_TRUE(at);
    EXPECT_LT(glm::distance(*at, pixel), 1e-6) << at->x << " " << at->y;
}

TEST(LightHandles, APointLightFollowsThePointerParallelToThePicture) {
    const Light light = point({1, 2, 0.5});
    LightDrag drag(handles, light, view, *handles.pixelOf(light, view));
    const Light moved = drag.movedTo({100, 220}, light, view);
    expectHandleAt(moved, {100, 220});
    EXPECT_EQ(moved.position.w, 1.0);
    EXPECT_NEAR(view.depthOf(glm::dvec3(moved.position)), view.depthOf(glm::dvec3(light.position)),
                1e-9);
}

TEST(LightHandles, AHandleGrabbedBesideItsMiddleDoesNotJump) {
    const Light light = point({1, 2, 0.5});
    const glm::dvec2 grabbed = *handles.pixelOf(light, view) + glm::dvec2(5, -3);
    LightDrag drag(handles, light, view, grabbed);
    expectHandleAt(drag.movedTo(grabbed, light, view), *handles.pixelOf(light, view));
}

TEST(LightHandles, ASunFollowsThePointerOnItsSphere) {
    for (const glm::dvec3& direction : {glm::dvec3(0.2, 0.5, 1), glm::dvec3(-0.1, 0.6, -1)}) {
        const Light light = sunTowards(direction);
        const glm::dvec2 grabbed = *handles.pixelOf(light, view);
        LightDrag drag(handles, light, view, grabbed);
        const Light moved = drag.movedTo(grabbed + glm::dvec2(10, 15), light, view);
        expectHandleAt(moved, grabbed + glm::dvec2(10, 15));
        EXPECT_EQ(moved.position.w, 0.0);
        EXPECT_NEAR(glm::length(glm::dvec3(moved.position)), 1.0, 1e-9);
        // It stays on its side of the sphere.
        EXPECT_GT(glm::dot(glm::dvec3(moved.position), glm::normalize(direction)), 0.8);
    }
}

TEST(LightHandles, ASunTakenOverTheRimComesBackOnTheOtherSide) {
    const Light light = sunTowards({0.2, 0.5, 1});
    const glm::dvec2 grabbed = *handles.pixelOf(light, view);
    LightDrag drag(handles, light, view, grabbed);
    Light moved = drag.movedTo({790, 300}, light, view); // far outside
    moved = drag.movedTo(grabbed, moved, view);
    expectHandleAt(moved, grabbed);
    EXPECT_GT(glm::dot(glm::dvec3(moved.position), view.forward()), 0.0);
}

TEST(LightHandles, TheNearestHandleInReachIsTaken) {
    const std::vector<Light> lights = {point({1, 2, 0.5}), point({-1, 2, 0}),
                                       sunTowards({0, 1, 0})};
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const glm::dvec2 pixel = *handles.pixelOf(lights[i], view) + glm::dvec2(3, 3);
        EXPECT_EQ(handles.lightAt(lights, pixel, view, 16.0), i);
    }
    EXPECT_EQ(handles.lightAt(lights, {5, 5}, view, 16.0), std::nullopt);
}

TEST(LightHandles, BehindTheEyeThereIsNoHandle) {
    EXPECT_FALSE(handles.pixelOf(point({6, 8, 20}), view));
}

TEST(LightHandles, ALightTurnsIntoASunAndBackWhereItsHandleIs) {
    const Light light = sunTowards(glm::normalize(glm::dvec3(1, 2, 3)));
    const Light turned = handles.turnedOver(light);
    EXPECT_EQ(turned.position.w, 1.0);
    EXPECT_LT(glm::distance(handles.turnedOver(turned).position, light.position), 1e-12);
}

} // namespace
} // namespace edgeshade::viewer
