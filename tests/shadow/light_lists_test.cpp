// The lights that a frame must handle: those that reach something, those that keep a shadow, and
// those in the tiles' lists.
#include "src/shadow/plan/light_lists.hpp"

#include "src/shadow/lights/light_range.hpp"
#include "src/shadow/view/light_budget.hpp"
#include "src/shadow/view/light_reach.hpp"
#include "src/shadow/view/reached_part.hpp"
#include "tests/support/hard_lights.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/scene_builder.hpp"

#include <gtest/gtest.h>
#include <set>

namespace edgeshade {
namespace {

using test::Random;
using test::SceneBuilder;

constexpr int width = 200, height = 120;

Light lamp(const glm::dvec3& position, double range, float candela = 1.0f) {
    Light light{glm::dvec4(position, 1.0), range};
    light.color = glm::vec3(candela);
    light.photometric = true;
    return light;
}

/// A floor of 10 x 10, seen from above its edge.
FrameView viewOf(const std::vector<Light>& lights) {
    const Scene scene = test::yard().scene();
    const Camera camera{{0, 4, 9}, {0, 0, 0}, 45.0};
    return makeFrameView(scene, {frustumOf(camera, double(width) / height), width, height, lights},
                         worldBounds(scene));
}

TEST(LightLists, HoldJustTheLightsThatReachATile) {
    Random random(11);
    std::vector<ReachingLight> lights;
    for (std::size_t i = 0; i < 300; ++i) {
        const int x = static_cast<int>(random.uniform(0, width - 1));
        const int y = static_cast<int>(random.uniform(0, height - 1));
        const int w = 1 + static_cast<int>(random.uniform(0, 60));
        const int h = 1 + static_cast<int>(random.uniform(0, 60));
        lights.push_back({2 * i, intersection({x, y, w, h}, {0, 0, width, height})});
    }
    const LightLists lists = listLights(lights, width, height);
    ASSERT_EQ(lists.columns, 7);
    ASSERT_EQ(lists.ofTile.size(), 7u * 4u);
    std::size_t entries = 0, longest = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const LightLists::Range& range = lists.ofTile[static_cast<std::size_t>(
                y / LightLists::tile * 7 + x / LightLists::tile)];
            std::set<std::size_t> listed;
            for (std::uint32_t e = range.first; e < range.first + range.count; ++e)
                listed.insert(lists.lights[lists.entries[e]]);
            ASSERT_EQ(listed.size(), range.count);
            longest = std::max(longest, listed.size());
            for (const ReachingLight& of : lights)
                if (!intersection(of.reach, {x, y, 1, 1}).empty()) {
                    ASSERT_TRUE(listed.contains(of.light)) << x << ", " << y;
                }
        }
    for (const ReachingLight& of : lights)
        for (std::size_t tile = 0; tile < lists.ofTile.size(); ++tile) {
            const PixelRectangle square{static_cast<int>(tile % 7) * LightLists::tile,
                                        static_cast<int>(tile / 7) * LightLists::tile,
                                        LightLists::tile, LightLists::tile};
            entries += !intersection(of.reach, square).empty();
        }
    EXPECT_EQ(lists.entries.size(), entries);
    EXPECT_EQ(lists.longest, longest);
}

TEST(LightReach, IsEmptyWhereNothingVisibleIsInTheBall) {
    const FrameView view = viewOf({lamp({0, 0, 0}, 1)});
    EXPECT_FALSE(lightReach(view, view.slices[0], lamp({0, 1, 0}, 2)).empty());
    // In the middle of the picture and of its depths, but above all geometry.
    EXPECT_TRUE(
        lightReach(view, view.slices[0], lamp({0, view.visible.high.y + 1.0, 4}, 0.9)).empty());
    EXPECT_TRUE(lightReach(view, view.slices[0], lamp({0, -3, 0}, 2.5)).empty());
}

TEST(LightBudget, LightsThatReachNothingAreNotDrawn) {
    FrameView view = viewOf({lamp({0, 1, 0}, 2), lamp({0, -9, 0}, 2), lamp({90, 1, 0}, 20),
                             test::sun({0, 1, 0}), lamp({0, 1, 40}, 5)});
    chooseLights(view, {});
    std::vector<bool> drawn, shadowed;
    for (const FrameLight& of : view.lights) {
        drawn.push_back(of.drawn);
        shadowed.push_back(of.shadowed);
    }
    EXPECT_EQ(drawn, (std::vector<bool>{true, false, false, true, false}));
    EXPECT_EQ(shadowed, (std::vector<bool>(5, true)));
}

TEST(LightBudget, KeepsTheLightsThatMatterMost) {
    // Weak, strong, equally strong but farther away, out of view, equal to the first.
    FrameView view =
        viewOf({lamp({1, 1, 0}, 3, 1.0f), lamp({1, 1, 0}, 3, 9.0f), lamp({1, 8, 0}, 9, 9.0f),
                lamp({1, -50, 0}, 3, 1e6f), lamp({1, 1, 0}, 3, 1.0f)});
    const auto kept = [&](std::size_t most) {
        FrameView chosen = view;
        chooseLights(chosen, most);
        std::vector<bool> shadowed;
        for (const FrameLight& of : chosen.lights)
            shadowed.push_back(of.shadowed);
        return shadowed;
    };
    EXPECT_EQ(kept(0), (std::vector<bool>(5, false)));
    EXPECT_EQ(kept(1), (std::vector<bool>{false, true, false, false, false}));
    EXPECT_EQ(kept(5), (std::vector<bool>(5, true)));
    EXPECT_EQ(kept(2), (std::vector<bool>{true, true, false, false, false}))
        << "of equal lights the first";
    EXPECT_EQ(kept(4), (std::vector<bool>{true, true, true, false, true}));
    EXPECT_EQ(importanceOf(view, view.lights[3].light), 0.0);
}

FrameView reachedPart(const FrameView& view, const Light& light) {
    FrameView part;
    findReachedPart(view, view.slices[0], light, part);
    return part;
}

TEST(ReachedPart, IsTheWindowAndTheDepthsOfTheBall) {
    const FrameView view = viewOf({lamp({0, 1, 0}, 1)});
    const Light light = lamp({0.5, 0.5, 0.5}, 1.0);
    const FrameView part = reachedPart(view, light);
    EXPECT_LT(part.frustum.size().x, 0.7 * view.frustum.size().x);
    EXPECT_LT(part.farthestDepth, view.farthestDepth);
    EXPECT_LE(part.visible.high.x, 1.5 * rangeWidening);
    Random random(3);
    int checked = 0;
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec3 point = glm::dvec3(light.position) + random.inCube();
        if (glm::distance(point, glm::dvec3(light.position)) > 1.0) continue;
        const glm::dvec3 seen(view.frustum.viewFromWorld * glm::dvec4(point, 1.0));
        const glm::dvec2 slope = glm::dvec2(seen) / -seen.z;
        if (glm::any(glm::lessThan(slope, view.frustum.low)) ||
            glm::any(glm::greaterThan(slope, view.frustum.high)))
            continue;
        ++checked;
        EXPECT_TRUE(glm::all(glm::greaterThanEqual(slope, part.frustum.low)));
        EXPECT_TRUE(glm::all(glm::lessThanEqual(slope, part.frustum.high)));
        EXPECT_LE(-seen.z, part.farthestDepth);
    }
    EXPECT_GT(checked, 500);
    const FrameView whole = reachedPart(view, test::sun({0, 1, 0}));
    EXPECT_EQ(whole.frustum, view.frustum);
    EXPECT_EQ(whole.farthestDepth, view.farthestDepth);
}

} // namespace
} // namespace edgeshade
