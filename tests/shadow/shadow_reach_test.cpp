// The pixels on which casters in a box may shadow visible geometry, and the planes around them.
#include "src/shadow/view/light_reach.hpp"
#include "src/shadow/view/view_planes.hpp"
#include "tests/support/hard_lights.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/scene_builder.hpp"

#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::Random;

constexpr int width = 200, height = 120;

FrameView viewOf(Random& random, const Light& light) {
    const Scene scene = test::yard().scene();
    const Camera camera{{random.uniform(-6, 6), random.uniform(0.5, 6), random.uniform(-6, 6)},
                        {random.uniform(-1, 1), 0.5, random.uniform(-1, 1)},
                        random.uniform(30, 90)};
    return makeFrameView(scene, {frustumOf(camera, double(width) / height), width, height, {light}},
                         worldBounds(scene));
}

glm::dvec3 within(Random& random, const Box& box) {
    return {random.uniform(box.low.x, box.high.x), random.uniform(box.low.y, box.high.y),
            random.uniform(box.low.z, box.high.z)};
}

/// The pixel that shows a point, in GL's rows; null: it isn't in the picture.
std::optional<glm::ivec2> pixelOf(const FrameView& view, const glm::dvec3& point) {
    const glm::dvec4 clip =
        view.clipFromView(view.slices.back()) * view.frustum.viewFromWorld * glm::dvec4(point, 1.0);
    if (clip.w <= 0.0 || std::abs(clip.x) >= clip.w || std::abs(clip.y) >= clip.w) return {};
    return glm::ivec2((0.5 * clip.x / clip.w + 0.5) * width,
                      (0.5 * clip.y / clip.w + 0.5) * height);
}

bool holds(const PixelRectangle& of, const glm::ivec2& pixel) {
    return pixel.x >= of.x && pixel.x < of.x + of.width && pixel.y >= of.y &&
           pixel.y < of.y + of.height;
}

TEST(ShadowReach, HoldsEveryVisiblePointBehindTheBox) {
    Random random(5);
    std::size_t tested = 0, smaller = 0;
    for (int round = 0; round < 400; ++round) {
        const glm::dvec3 at{random.uniform(-6, 6), random.uniform(-1, 7), random.uniform(-6, 6)};
        const Light light{glm::dvec4(at, round % 2)};
        FrameView view = viewOf(random, light);
        if (view.visible.empty()) continue;
        Box box;
        const glm::dvec3 low = within(random, {{-4, 0, -4}, {4, 3, 4}});
        box.add(low);
        box.add(low + within(random, {{0, 0, 0}, {1, 2, 1}}));
        const PixelRectangle reach = shadowReach(view, box, light);
        smaller += reach.width < width || reach.height < height;
        view.part = reach;
        for (int i = 0; i < 200; ++i) {
            const glm::dvec3 blocked = within(random, box);
            const glm::dvec3 away = light.position.w == 0.0 ? -at : blocked - at;
            const glm::dvec3 point = blocked + random.uniform(0, 3) * away;
            const auto pixel = pixelOf(view, point);
            if (!pixel || !view.visible.holds(point)) continue;
            const double depth = -(view.frustum.viewFromWorld * glm::dvec4(point, 1.0)).z;
            if (depth < view.near() || depth > view.farthestDepth) continue;
            ++tested;
            EXPECT_TRUE(holds(reach, *pixel)) << "round " << round;
            const ViewPlanes planes = viewPlanes(view, view.slices.back(), glm::dmat4(1.0));
            for (std::size_t side = 0; side < 4; ++side)
                EXPECT_GE(glm::dot(planes[side], glm::dvec4(point, 1.0)), -1e-9)
                    << "round " << round;
        }
    }
    EXPECT_GT(tested, 5000u);
    EXPECT_GT(smaller, 100u) << "most rectangles should leave something out";
}

TEST(ShadowReach, EndsWhereShadowsLeaveTheVisibleGeometry) {
    const Camera camera{{0, 1.5, 8}, {0, 0.5, 0}, 60};
    const Scene scene = test::yard().scene();
    // Both shadows are 1 m long on the ground.
    for (const glm::dvec4& position : {glm::dvec4(1, 1, 0, 0), glm::dvec4(1, 2, 0, 1)}) {
        const Light light{position};
        const FrameView view = makeFrameView(
            scene, {frustumOf(camera, double(width) / height), width, height, {light}},
            worldBounds(scene));
        const PixelRectangle reach = shadowReach(view, {{-0.3, 0.0, -0.3}, {0.3, 1.0, 0.3}}, light);
        EXPECT_FALSE(reach.empty());
        EXPECT_GT(reach.x, width / 5) << "to the left";
        EXPECT_GT(reach.y, height / 8) << "below the ground";
        const Box below{{-0.3, -9.0, -0.3}, {0.3, -8.0, 0.3}};
        EXPECT_TRUE(shadowReach(view, below, light).empty()) << "nothing visible is behind it";
    }
}

TEST(ShadowReach, OfNothingIsEmptyAndAroundTheLightIsWhole) {
    Random random(6);
    const Light lamp{{0.2, 1.0, 0.3, 1.0}};
    const FrameView view = viewOf(random, lamp);
    EXPECT_TRUE(shadowReach(view, {}, lamp).empty());
    const PixelRectangle whole{0, 0, width, height};
    EXPECT_EQ(shadowReach(view, {{0, 0, 0}, {1, 2, 1}}, lamp), whole) << "the light is in the box";
    EXPECT_EQ(shadowReach(view, {{0.2, 1.0, 0.3}, {1, 2, 1}}, lamp), whole) << "on its corner";
    FrameView unknown = view;
    unknown.visible = {};
    EXPECT_EQ(shadowReach(unknown, {{4, 0, 4}, {5, 2, 5}}, lamp), whole);
    const Box flat{{-1e-300, 0.5, -1e-300}, {1e-300, 0.5, 1e-300}},
        huge{glm::dvec3(-1e30), glm::dvec3(1e30)};
    EXPECT_FALSE(shadowReach(view, flat, {{0.5, 1, -0.3, 0.0}}).empty());
    EXPECT_EQ(shadowReach(view, huge, {{0.5, 1, -0.3, 0.0}}), whole);
}

} // namespace
} // namespace edgeshade
