// A sun's cascades: parts of the visible geometry that together cover it, and keep to whole texels.

#include "src/render/shadow_map/cascades.hpp"

#include "src/render/shadow_map/shadow_map_view.hpp"
#include "tests/support/headless.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <optional>

namespace edgeshade {
namespace {

using test::sun;

constexpr double near = 0.1, far = 200.0;
const MapSubject wide{{glm::dvec3(-1000.0), glm::dvec3(1000.0)}, {}, {}};

FrameView frameAt(const Camera& camera) {
    FrameView frame;
    frame.frustum = frustumOf(camera, 1.5);
    frame.slices = {{near, far}};
    frame.farthestDepth = far;
    return frame;
}

ShadowMapView viewOf(const FrameView& frame, const Light& light = sun({0.5, 1, -0.3}),
                     int count = 4, const MapSubject& subject = wide) {
    ShadowMapSettings settings;
    settings.size = 512;
    settings.kind = MapKind::cascades;
    settings.cascades = count;
    return sunMapView(glm::dvec3(light.position), subject, frame, settings);
}

/// Position of a place in a cascade, 0..1 in its inner part.
glm::dvec2 placeIn(const ShadowMapView& view, std::size_t cascade, const glm::dvec3& world) {
    const glm::dvec2 at(view.mapFromWorld * glm::dvec4(world, 1.0));
    const glm::dvec4& part = view.cascades[cascade];
    return (at * glm::dvec2(part) + glm::dvec2(part.z, part.w) - view.cascadeMargin) /
           (1.0 - 2.0 * view.cascadeMargin);
}

bool isIn(const glm::dvec2& place) {
    return place.x > -1e-9 && place.x < 1.0 + 1e-9 && place.y > -1e-9 && place.y < 1.0 + 1e-9;
}

TEST(Cascades, EndsGrowFromEqualLengthsTowardsEqualRatios) {
    const std::vector<double> ends = cascadeEnds(1.0, 1000.0, 4);
    ASSERT_EQ(ends.size(), 4u);
    EXPECT_EQ(ends.back(), 1000.0);
    double before = 1.0;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const double part = static_cast<double>(i + 1) / 4.0;
        EXPECT_GT(ends[i], before);
        EXPECT_GT(ends[i], std::pow(1000.0, part));
        EXPECT_LT(ends[i], 1.0 + 999.0 * part);
        before = ends[i];
    }
    EXPECT_EQ(cascadeEnds(2.0, 5.0, 1), std::vector{5.0});
}

TEST(Cascades, CoverAllThatIsVisible) {
    for (const double degrees : {20.0, 60.0, 100.0})
        for (const int count : {1, 2, 3, 4})
            for (const Light& light : {sun({0.5, 1, -0.3}), sun({0, 1, 0}), sun({1, 0.01, 0})}) {
                const FrameView frame = frameAt({{3, 2, 7}, {-4, 1, 2}, degrees});
                const ShadowMapView view = viewOf(frame, light, count);
                const glm::dmat4 worldFromView = glm::inverse(frame.frustum.viewFromWorld);
                for (int i = 0; i <= 40; ++i)
                    for (const glm::dvec2& corner :
                         {glm::dvec2(-1, -1), glm::dvec2(1, -1), glm::dvec2(-1, 1),
                          glm::dvec2(1, 1), glm::dvec2(0, 0)}) {
                        const double depth = near * std::pow(far / near, i / 40.0);
                        const glm::dvec3 place(
                            worldFromView *
                            glm::dvec4(depth * glm::dvec3(frame.frustum.windowAt(corner), -1.0),
                                       1.0));
                        bool covered = false;
                        for (std::size_t c = 0; c < view.cascades.size(); ++c)
                            covered = covered || isIn(placeIn(view, c, place));
                        ASSERT_TRUE(covered) << count << " cascades, depth " << depth;
                    }
            }
}

TEST(Cascades, AreFinerNearTheEye) {
    const ShadowMapView view = viewOf(frameAt({{3, 2, 7}, {-4, 1, 2}, 60.0}));
    ASSERT_EQ(view.cascades.size(), 4u);
    for (std::size_t c = 0; c + 1 < 4; ++c)
        EXPECT_GT(view.cascades[c].x, 2.0 * view.cascades[c + 1].x);
}

TEST(Cascades, TheFirstThatHoldsAllCastersIsTheLast) {
    const MapSubject small{{glm::dvec3(-1.0), glm::dvec3(1.0)}, {}, {}};
    const FrameView frame = frameAt({{3, 2, 7}, {0, 0, 0}, 60.0});
    const ShadowMapView view = viewOf(frame, sun({0, 1, 0}), 4, small);
    ASSERT_LT(view.cascades.size(), 4u);
    for (const glm::dvec3& corner : {glm::dvec3(-1, 0, -1), glm::dvec3(1, 0, 1)})
        EXPECT_TRUE(isIn(placeIn(view, view.cascades.size() - 1, corner)));
}

/// Expects that the two views have the same texels, all of them moved equally.
void expectSameTexels(const ShadowMapView& one, const ShadowMapView& other) {
    ASSERT_EQ(one.cascades.size(), other.cascades.size());
    for (std::size_t c = 0; c < one.cascades.size(); ++c) {
        std::optional<glm::dvec2> moved;
        for (const glm::dvec3& place :
             {glm::dvec3(0, 0, 0), glm::dvec3(9, 4, -7), glm::dvec3(-80, 3, 60)}) {
            const auto texelOf = [&](const ShadowMapView& view) {
                const glm::dvec2 at(view.mapFromWorld * glm::dvec4(place, 1.0));
                return 512.0 * (at * glm::dvec2(view.cascades[c]) +
                                glm::dvec2(view.cascades[c].z, view.cascades[c].w));
            };
            const glm::dvec2 by = texelOf(other) - texelOf(one);
            EXPECT_NEAR(by.x, std::round(by.x), 1e-6);
            EXPECT_NEAR(by.y, std::round(by.y), 1e-6);
            EXPECT_LT(glm::distance(by, moved.value_or(by)), 1e-6);
            moved = by;
        }
    }
}

TEST(Cascades, DontShimmerWhenTheCameraMovesOrTurns) {
    const Camera camera{{3, 2, 7}, {-4, 1, 2}, 60.0};
    const ShadowMapView first = viewOf(frameAt(camera));
    for (const glm::dvec3& step :
         {glm::dvec3(0.013, 0, 0), glm::dvec3(0, 1.7, -0.3), glm::dvec3(31, -2, 9)}) {
        expectSameTexels(first, viewOf(frameAt({camera.from + step, camera.to + step, 60.0})));
        expectSameTexels(first, viewOf(frameAt({camera.from, camera.to + step, 60.0})));
    }
}

TEST(Cascades, AreKeptWhileTheCameraMovesLessThanATexel) {
    const Camera camera{{3, 2, 7}, {-4, 1, 2}, 60.0};
    const glm::dvec3 step(1e-7, 0, 1e-7);
    EXPECT_TRUE(viewOf(frameAt(camera)) ==
                viewOf(frameAt({camera.from + step, camera.to + step, 60.0})));
}

TEST(Cascades, StayTheSameWhileDepthsChangeALittle) {
    FrameView frame = frameAt({{3, 2, 7}, {-4, 1, 2}, 60.0});
    frame.slices[0].near = 0.11;
    frame.farthestDepth = 197.0;
    const ShadowMapView one = viewOf(frame);
    frame.slices[0].near = 0.112;
    frame.farthestDepth = 193.0;
    EXPECT_TRUE(one == viewOf(frame));
}

TEST(Cascades, OfAnOrthographicPictureAreOne) {
    FrameView frame = frameAt({{3, 2, 7}, {-4, 1, 2}, 60.0});
    frame.frustum = frustumOf(Camera{{3, 2, 7}, {-4, 1, 2}, 60.0}, 1.5, 12.0);
    frame.slices = {{-20.0, 200.0}};
    EXPECT_EQ(viewOf(frame).cascades.size(), 1u);
}

} // namespace
} // namespace edgeshade
