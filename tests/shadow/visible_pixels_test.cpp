// Shadows are counted only in the rectangle of pixels with surfaces: it must miss none.

#include "src/shadow/view/light_reach.hpp"
#include "tests/support/hard_lights.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/scene_builder.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::Random;
using test::SceneBuilder;
using test::TestView;

constexpr int width = 120, height = 90;

/// The rectangle of pixels, from the lower left, in which a picture of the scene has surfaces.
PixelRectangle drawnPixels(const Scene& scene, const Camera& camera) {
    RenderSettings settings;
    settings.shadows = ShadowMethod::none;
    const TestView view{camera, {test::sun({0, 1, 0})}, width, height, true};
    const auto mask = test::drawScene(scene, view, settings);
    PixelRectangle drawn;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if (mask[static_cast<std::size_t>(4 * (y * width + x) + 3)] != 0)
                drawn = united(drawn, {x, height - 1 - y, 1, 1});
    return drawn;
}

PixelRectangle visiblePixelsOf(const Scene& scene, const Camera& camera) {
    LoadedScene loaded;
    loaded.scene = scene;
    const FrameRequest request{frustumOf(camera, static_cast<double>(width) / height),
                               width,
                               height,
                               {test::sun({0, 1, 0})},
                               {}};
    return visiblePixels(makeFrameView(loaded.scene, request, worldBounds(scene)));
}

bool holds(const PixelRectangle& outer, const PixelRectangle& inner) {
    const PixelRectangle both = intersection(outer, inner);
    return both.width == inner.width && both.height == inner.height;
}

TEST(VisiblePixels, HoldWhatIsDrawnAndLittleMore) {
    Random random(11);
    int drawn = 0, tight = 0, farOff = 0;
    for (int i = 0; i < 120; ++i) {
        // Triangles, some beside or behind the eye, small or large, some far from the batch's own
        // origin.
        const double offset = i % 3 == 0 ? random.magnitude(2, 4) : 0.0;
        const glm::dvec3 center = offset * random.inCube();
        SceneBuilder builder;
        const int triangles = 1 + random.below(40);
        for (int t = 0; t < triangles; ++t) {
            const glm::dvec3 at = center + 2.0 * random.inCube();
            const double size = random.magnitude(-1, 0.3);
            const auto corner = [&] { return glm::vec3(at + size * random.inCube()); };
            builder.triangle(corner(), corner(), corner());
        }
        const glm::dmat4 placing = glm::translate(glm::dmat4(1.0), 100.0 * random.inCube());
        const Scene scene = builder.placedBy(placing).scene();
        const auto inWorld = [&](const glm::dvec3& p) {
            return glm::dvec3(placing * glm::dvec4(p, 1.0));
        };
        const Camera camera{inWorld(center + 4.0 * random.inCube()),
                            inWorld(center + random.inCube()), random.uniform(10, 120)};
        const PixelRectangle found = drawnPixels(scene, camera);
        if (found.empty()) continue;
        const PixelRectangle visible = visiblePixelsOf(scene, camera);
        ASSERT_TRUE(holds(visible, found))
            << i << ": " << found.width << "x" << found.height << " at " << found.x << ", "
            << found.y << " in " << visible.width << "x" << visible.height << " at " << visible.x
            << ", " << visible.y;
        ++drawn;
        farOff += offset > 0.0; // where floats are pixels off
        tight +=
            offset == 0.0 && visible.width <= found.width + 6 && visible.height <= found.height + 6;
    }
    EXPECT_GT(drawn, 60);
    EXPECT_GT(farOff, 15);
    EXPECT_GT(tight, (drawn - farOff) * 2 / 3);
}

TEST(VisiblePixels, AreAllWhereNothingIsKnown) {
    FrameView view;
    view.width = width;
    view.height = height;
    const PixelRectangle all = visiblePixels(view);
    EXPECT_TRUE(holds(all, {0, 0, width, height}));
}

} // namespace
} // namespace edgeshade
