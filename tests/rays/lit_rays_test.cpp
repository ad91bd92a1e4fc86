// Points on surfaces whose light is known without tracing.
#include "src/rays/exact_blocking.hpp"
#include "src/rays/lit_rays.hpp"
#include "tests/support/scene_builder.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using rays::LitBits;
using rays::LitRays;
using rays::SurfacePoint;
using test::SceneBuilder;

const glm::dvec3 up(0, 1, 0);

/// The first triangle that has the place in its plane and around it, seen from above.
std::uint32_t triangleAt(const LitRays& rays, const glm::dvec3& place) {
    for (std::uint32_t i = 0; i < rays.triangles().size(); ++i) {
        const rays::SurfaceTriangle& t = rays.triangles()[i];
        const auto turn = [&](const glm::dvec3& a, const glm::dvec3& b) {
            return glm::cross(b - a, place - a).y;
        };
        const double ab = turn(t.a, t.b), bc = turn(t.b, t.c), ca = turn(t.c, t.a);
        if (glm::dot(normalOf(t), place - t.a) == 0.0 &&
            ((ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0)))
            return i;
    }
    return SurfacePoint::none;
}

LitRays raysOf(const Scene& scene) {
    return {scene, rays::surfaceTriangles(scene, glm::dvec3(0.0), false, false)};
}

bool isLit(const LitRays& rays, const SurfacePoint& point, const glm::dvec3& direction) {
    return rays.lit(std::vector{point}, std::vector{direction}).at(0, 0);
}

// A wall 2 high at x = 0 to 1 shades the floor as far as 2 / slope beyond it.
TEST(LitRays, KnowTheShadowOfAWall) {
    const Scene scene = SceneBuilder().floor(10).box({0, 0, -5}, {1, 2, 5}).scene();
    const LitRays rays = raysOf(scene);
    for (const double x : {1.01, 4.99, 5.01, 8.0}) {
        const glm::dvec3 place(x, 0, 0.3);
        const SurfacePoint point = SurfacePoint::at(place, up, triangleAt(rays, place));
        EXPECT_EQ(isLit(rays, point, {-2, 1, 0}), x > 5.0) << x;
        EXPECT_TRUE(isLit(rays, point, {2, 1, 0}));
    }
}

TEST(LitRays, ASheetIsDarkFromTheOtherSide) {
    const Scene scene = SceneBuilder().floor(3).scene();
    const LitRays rays = raysOf(scene);
    const SurfacePoint above = SurfacePoint::at({1, 0, 0.5}, up, 0),
                       below = SurfacePoint::at({1, 0, 0.5}, -up, 0);
    EXPECT_TRUE(isLit(rays, above, {0.2, 1, 0}));
    EXPECT_FALSE(isLit(rays, above, {0.2, -1, 0}));
    EXPECT_TRUE(isLit(rays, below, {0.2, -1, 0}));
    EXPECT_FALSE(isLit(rays, below, {0.2, 1, 0}));
}

TEST(LitRays, CoincidentSheetsDoNotShadeEachOther) {
    const Scene scene = SceneBuilder().floor(3).floor(4).scene();
    EXPECT_TRUE(isLit(raysOf(scene), SurfacePoint::at({1, 0, 0.5}, up, 0), {0.2, 1, 0.1}));
}

// More coincident triangles than a packet remembers, from one direction after another.
TEST(LitRays, ManyCoincidentSheetsShadeNothingFromAnywhere) {
    SceneBuilder builder;
    for (int i = 0; i < 40; ++i)
        builder.floor(3.0f + static_cast<float>(i));
    const Scene scene = builder.box({0, 1, -1}, {1, 2, 1}).scene();
    const LitRays rays = raysOf(scene);
    std::vector<SurfacePoint> points;
    for (int i = 0; i < 20; ++i)
        points.push_back(SurfacePoint::at({0.05 * i, 0, 0.5}, up, 0));
    std::vector<glm::dvec3> directions;
    for (int i = 0; i < 9; ++i)
        directions.emplace_back(i % 3 == 0 ? 0.0 : -5.0, 1,
                                0.01 * i); // every third one hits the box
    const LitBits bits = rays.lit(points, directions);
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t d = 0; d < directions.size(); ++d)
            EXPECT_EQ(bits.at(i, d), d % 3 != 0) << i << " " << d;
}

// Doubles can't tell on which side of an edge the first ray passes; the next one is blocked.
TEST(LitRays, ATriangleThatIsMissedByAHairBlocksFromElsewhere) {
    const Scene scene = SceneBuilder().box({0, 1, -1}, {1, 2, 1}).scene();
    const SurfacePoint point = SurfacePoint::at({-1e-20, 0, 0.3}, up, SurfacePoint::none);
    const LitBits bits = raysOf(scene).lit(
        std::vector{point}, std::vector<glm::dvec3>{{0, 1, 0}, {0.1, 1, 0}, {0, 1, 0}});
    EXPECT_TRUE(bits.at(0, 0));
    EXPECT_FALSE(bits.at(0, 1));
    EXPECT_TRUE(bits.at(0, 2));
}

TEST(ExactBlocking, TellsPointsInATrianglesPlane) {
    const rays::Corners triangle = {{{0, 1, 0}, {1, 1, 0}, {0, 1, 1}}};
    const auto blocking = [&](const glm::dvec3& origin, const glm::dvec3& towards) {
        return rays::blockingExactly({origin}, nullptr, triangle, glm::dvec4(towards, 0.0));
    };
    EXPECT_EQ(blocking({0.2, 0, 0.2}, up), rays::Blocking::blocks);
    EXPECT_EQ(blocking({0.2, 0, 0.2}, -up), rays::Blocking::misses);
    EXPECT_EQ(blocking({0.2, 0, 0.2}, {1, 0, 0}), rays::Blocking::misses);
    EXPECT_EQ(blocking({0.2, 1, 0.2}, up), rays::Blocking::inPlane);
    EXPECT_EQ(blocking({0.2, 1, 0.2}, {1, 0, 0}), rays::Blocking::inPlane);
    EXPECT_EQ(blocking({0.2, std::nextafter(1.0, 0.0), 0.2}, up), rays::Blocking::blocks);
}

TEST(LitRays, SeeThroughSurfacesAreLitFromBothSidesAndShadeNothing) {
    Material glass;
    glass.alphaMode = AlphaMode::blend;
    const Scene scene = SceneBuilder().floor(3).material(glass).floor(2, 1.0f).scene();
    const LitRays rays = raysOf(scene);
    EXPECT_TRUE(isLit(rays, SurfacePoint::at({0.5, 0, 0.25}, up, 0), {0.2, 1, 0}));
    const auto pane = static_cast<std::uint32_t>(rays.triangles().size() - 1);
    EXPECT_FALSE(rays.triangles()[pane].casts);
    EXPECT_TRUE(isLit(rays, SurfacePoint::at({0.5, 1, 0.25}, -up, pane), {0.2, 1, 0}));
}

TEST(LitRays, AGrazedSurfaceIsDark) {
    const Scene scene = SceneBuilder().floor(3).scene();
    const LitRays rays = raysOf(scene);
    const SurfacePoint point = SurfacePoint::at({1, 0, 0.5}, up, 0);
    EXPECT_FALSE(isLit(rays, point, {1, 0.99e-5, 0}));
    EXPECT_TRUE(isLit(rays, point, {1, 1.01e-5, 0}));
}

TEST(LitRays, HolesLetLightThrough) {
    Material leaves;
    leaves.alphaMode = AlphaMode::mask;
    const Scene scene = SceneBuilder().floor(3).material(leaves).floor(2, 1.0f).scene();
    std::vector<rays::SurfaceTriangle> triangles =
        rays::surfaceTriangles(scene, glm::dvec3(0.0), false, true);
    // Light passes where a leaf is crossed at x > 0.
    const LitRays rays(scene, triangles, [](const rays::SurfaceTriangle& t, double u, double v) {
        return (t.a + u * (t.b - t.a) + v * (t.c - t.a)).x > 0.0;
    });
    EXPECT_FALSE(isLit(rays, SurfacePoint::at({-0.5, 0, 0.25}, up, 0), {0, 1, 0}));
    EXPECT_TRUE(isLit(rays, SurfacePoint::at({-0.5, 0, 0.25}, up, 0), {0.6, 1, 0}));
    EXPECT_TRUE(isLit(rays, SurfacePoint::at({0.5, 0, 0.25}, up, 0), {0, 1, 0}));
}

// Casters that no point lies on may be corners alone. They have no holes, whatever others have.
TEST(LitRays, CornersAloneShade) {
    Material leaves;
    leaves.alphaMode = AlphaMode::mask;
    const Scene scene =
        SceneBuilder().material(leaves).floor(10).box({0, 0, -5}, {1, 2, 5}).scene();
    std::vector<rays::SurfaceTriangle> surfaces =
        rays::surfaceTriangles(scene, glm::dvec3(0.0), false, true);
    std::vector<rays::Corners> corners;
    for (const rays::SurfaceTriangle& t : surfaces)
        corners.push_back({t.a, t.b, t.c});
    std::size_t floor = 0;
    while (surfaces[floor].a.y == 0.0 && surfaces[floor].b.y == 0.0 && surfaces[floor].c.y == 0.0)
        ++floor;
    ASSERT_GT(floor, 0u);
    ASSERT_LT(floor, surfaces.size());
    surfaces.resize(floor);
    const LitRays rays(
        scene, std::make_shared<const rays::SurfaceSet>(std::move(surfaces), std::move(corners)),
        [](const rays::SurfaceTriangle&, double, double) { return true; });
    for (const double x : {1.01, 4.99, 5.01, 8.0}) {
        const glm::dvec3 place(x, 0, 0.3);
        const SurfacePoint point = SurfacePoint::at(place, up, triangleAt(rays, place));
        EXPECT_EQ(isLit(rays, point, {-2, 1, 0}), x > 5.0) << x;
    }
}

TEST(LitRays, ManyPointsAndDirectionsHaveTheirBits) {
    const Scene scene = SceneBuilder().floor(10).box({0, 0, -5}, {1, 2, 5}).scene();
    const LitRays rays = raysOf(scene);
    std::vector<SurfacePoint> points;
    for (int i = 0; i < 333; ++i) {
        const glm::dvec3 place(1.5 + 0.025 * i, 0, 0.01 * (i % 7));
        points.push_back(SurfacePoint::at(place, up, triangleAt(rays, place)));
    }
    std::vector<glm::dvec3> directions;
    for (int i = 0; i < 300; ++i)
        directions.push_back({-10.0 + 0.1 * i, 2, 0.003 * i});
    double last = 0.0;
    const LitBits bits = rays.lit(points, directions, {}, [&](double share) {
        EXPECT_GE(share, last);
        last = share;
    });
    EXPECT_GT(last, 0.0);
    EXPECT_LE(last, 1.0);
    ASSERT_EQ(bits.points(), 333u);
    ASSERT_EQ(bits.directions(), 300u);
    std::size_t lit = 0;
    for (std::size_t p = 0; p < points.size(); ++p) {
        std::size_t count = 0;
        for (std::size_t d = 0; d < directions.size(); ++d) {
            // The box's top edge at x = 1, y = 2, seen from x.
            const double x = points[p].origin.x, run = directions[d].x;
            const bool expected = run > -(x - 1.0);
            EXPECT_EQ(bits.at(p, d), expected) << p << ", " << d;
            count += expected;
        }
        EXPECT_EQ(bits.count(p), count);
        lit += count;
    }
    const LitBits alone = rays.lit(points, directions, {1});
    for (std::size_t p = 0; p < points.size(); ++p)
        ASSERT_TRUE(std::equal(bits.of(p).begin(), bits.of(p).end(), alone.of(p).begin()));
    EXPECT_GT(lit, 10000u);
    EXPECT_EQ(rays.lit({}, directions).points(), 0u);
    EXPECT_EQ(rays.lit(points, {}).count(0), 0u);
}

} // namespace
} // namespace edgeshade
