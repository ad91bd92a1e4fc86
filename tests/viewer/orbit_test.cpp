#include "src/viewer/orbit.hpp"

#include "src/shadow/view/frustum.hpp"

#include <gtest/gtest.h>

namespace edgeshade::viewer {
namespace {

const PictureView view{{{3, 2, 5}, {0.5, 0, 0}, 50.0}, 800, 600};

void expectNear(const glm::dvec3& a, const glm::dvec3& b, double tolerance = 1e-9) {
    EXPECT_LT(glm::distance(a, b), tolerance) << a.x << " " << a.y << " " << a.z;
}

TEST(PictureView, APointIsSeenWhereItsRayGoes) {
    const glm::dvec2 pixel(123, 456);
    const glm::dvec3 point = view.pointAt(pixel, 4.0);
    EXPECT_NEAR(view.depthOf(point), 4.0, 1e-12);
    EXPECT_LT(glm::distance(view.pixelOf(point), pixel), 1e-9);
    const Ray ray = view.rayThrough(pixel);
    expectNear(ray.from + ray.direction * glm::distance(ray.from, point), point);
}

TEST(PictureView, PixelsAreThoseOfTheRenderer) {
    const glm::dvec3 point(0.7, -0.4, 1.1);
    const glm::dvec4 clip = clipFromView(frustumOf(view.camera, view.aspect()), 0.1) *
                            viewFromWorld(view.camera) * glm::dvec4(point, 1.0);
    const glm::dvec2 pixel(400 * (1 + clip.x / clip.w), 300 * (1 - clip.y / clip.w));
    EXPECT_LT(glm::distance(view.pixelOf(point), pixel), 1e-9);
}

TEST(Orbit, TheEyeKeepsItsDistanceAndThePivot) {
    const Camera turned = orbited(view.camera, 0.3, -0.2);
    EXPECT_NEAR(glm::distance(turned.from, turned.to),
                glm::distance(view.camera.from, view.camera.to), 1e-12);
    expectNear(turned.to, view.camera.to);
    expectNear(orbited(view.camera, 0.0, 0.0).from, view.camera.from);
}

TEST(Orbit, YawGoesToTheRightAndPitchUp) {
    const Camera front{{0, 0, 4}, {0, 0, 0}, 45.0};
    expectNear(orbited(front, glm::radians(90.0), 0.0).from, {4, 0, 0});
    EXPECT_GT(orbited(front, 0.0, 0.1).from.y, 0.0);
}

TEST(Orbit, NeverGoesOverAPole) {
    for (const double sign : {1.0, -1.0}) {
        Camera camera = view.camera;
        glm::dvec3 right = glm::dmat3(glm::transpose(viewFromWorld(camera)))[0];
        for (int i = 0; i < 50; ++i) {
            camera = orbited(camera, 0.0, sign * 0.2);
            const glm::dvec3 now = glm::dmat3(glm::transpose(viewFromWorld(camera)))[0];
            expectNear(now, right, 1e-6); // pitch alone never rolls the picture
        }
        EXPECT_GT(sign * (camera.from.y - camera.to.y), 0.0);
    }
}

TEST(Orbit, LeavesAPoleWithoutTurningThePicture) {
    for (const double y : {4.0, -4.0}) {
        const Camera camera{{0, y, 0}, {0, 0, 0}, 45.0};
        const glm::dvec3 before = glm::dmat3(glm::transpose(viewFromWorld(camera)))[0];
        const Camera turned = orbited(camera, 0.0, y > 0 ? -0.1 : 0.1);
        expectNear(glm::dmat3(glm::transpose(viewFromWorld(turned)))[0], before, 1e-6);
    }
}

TEST(Pan, WhatIsAtTheDepthFollowsThePointer) {
    const glm::dvec3 point = view.pointAt({200, 300}, 3.0);
    PictureView after = view;
    after.camera = panned(view, {50, -20}, 3.0);
    EXPECT_LT(glm::distance(after.pixelOf(point), glm::dvec2(250, 280)), 1e-9);
}

TEST(Zoom, WhatIsZoomedToStaysUnderThePointerAndBecomesThePivot) {
    const glm::dvec3 target = view.pointAt({650, 130}, 2.5);
    const glm::dvec2 pixel = view.pixelOf(target);
    PictureView after = view;
    for (int i = 0; i < 30; ++i) {
        after.camera = zoomed(after.camera, target, 0.8, 1e-6, 1e6);
        EXPECT_LT(glm::distance(after.pixelOf(target), pixel), 1e-6);
    }
    expectNear(after.forward(), view.forward(), 1e-9);
    EXPECT_LT(glm::distance(after.camera.to, target), 0.01);
}

TEST(Zoom, StopsAtItsEnds) {
    const glm::dvec3 target = view.camera.to;
    EXPECT_EQ(zoomed(view.camera, target, 0.5, 4.0, 100.0).from, view.camera.from);
    EXPECT_EQ(zoomed(view.camera, target, 2.0, 0.1, 6.0).from, view.camera.from);
}

} // namespace
} // namespace edgeshade::viewer
