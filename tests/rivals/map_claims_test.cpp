// Published claims about shadow maps, tested one by one: docs/shadow-maps.md lists them with the
// results.

#include "tests/support/map_pictures.hpp"

#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::greyPixels;
using test::leakIn;
using test::maps;
using test::pointLight;
using test::SceneBuilder;
using test::sun;
using test::wrongIn;

constexpr double degrees = 45.0;
const Camera corner{{5, 4, 6}, {0, 0.5, 0}, 50.0};
const Light slanted = sun({0.5, 1, -0.3}), overhead = sun({0, 1, 0});

/// Percentage of wrong pixels, for a map of this many texels.
double wrongOf(const Scene& scene, const Camera& camera, const Light& light, MapKind kind, int size,
               WarpGrid grid = WarpGrid::rectilinear) {
    return wrongIn(scene, camera, light, maps(kind, MapFilter::compare, 1, size, grid));
}

// A large floor with a small object, seen from close by: most texels of a single map are elsewhere.
TEST(CascadedMaps, AreFinerThanOneMapOfAsManyBytes) {
    const Scene scene = SceneBuilder().floor(100).box({-1, 0.5f, -1}, {1, 2, 1}).scene();
    const double one = wrongOf(scene, corner, slanted, MapKind::cube, 512);
    const double four = wrongOf(scene, corner, slanted, MapKind::cascades, 256);
    std::printf("%.3f %% wrong of one map, %.3f %% of cascades\n", one, four);
    EXPECT_LT(four, 0.3 * one);
}

// Rosen 2012: texels go to the visible parts.
TEST(WarpedMaps, AreFinerThanOneMapOfAsManyTexels) {
    const Scene scene = SceneBuilder().floor(100).box({-1, 0.5f, -1}, {1, 2, 1}).scene();
    const double one = wrongOf(scene, corner, slanted, MapKind::cube, 512);
    for (const WarpGrid grid : {WarpGrid::rectilinear, WarpGrid::nonOrthogonal}) {
        const double warped = wrongOf(scene, corner, slanted, MapKind::warped, 512, grid);
        std::printf("%.3f %% wrong of one map, %.3f %% warped\n", one, warped);
        EXPECT_LT(warped, 0.2 * one);
    }
}

/// Posts along a diagonal of the light's axes, seen from above: the important part differs from row
/// to row.
Scene diagonalPosts() {
    SceneBuilder builder = SceneBuilder().floor(40);
    for (int i = -12; i <= 12; ++i) {
        const float at = static_cast<float>(i);
        builder.box({at - 0.15f, 0, at - 0.15f}, {at + 0.15f, 1.5f, at + 0.15f});
    }
    return builder.scene();
}
const Camera alongDiagonal{{14, 3, 14}, {0, 0, 0}, 25.0};

// Milet et al. 2015: rows and columns that are warped independently leave few texels beside a
// diagonal.
TEST(WarpedMaps, ANonOrthogonalGridIsFinerAlongADiagonal) {
    const Scene scene = diagonalPosts();
    const double rectilinear =
        wrongOf(scene, alongDiagonal, slanted, MapKind::warped, 256, WarpGrid::rectilinear);
    const double free =
        wrongOf(scene, alongDiagonal, slanted, MapKind::warped, 256, WarpGrid::nonOrthogonal);
    std::printf("%.3f %% wrong rectilinear, %.3f %% non-orthogonal\n", rectilinear, free);
    EXPECT_LT(free, 0.9 * rectilinear);
}

// Rosen and Milet tessellate, since straight edges are curved in a warped map. Cut along the warp's
// lines, a beam of twelve triangles casts the same shadow as one of many.
TEST(WarpedMaps, LongTrianglesCastAsShortOnesDo) {
    const Camera camera{{3, 4, 9}, {0, 0, 0}, 50.0};
    SceneBuilder coarse = SceneBuilder().floor(60);
    coarse.box({-50, 2, -0.2f}, {50, 2.2f, 0.2f});
    SceneBuilder fine = SceneBuilder().floor(60);
    for (int i = -100; i < 100; ++i) {
        const float x = 0.5f * static_cast<float>(i);
        fine.box({x, 2, -0.2f}, {x + 0.5f, 2.2f, 0.2f});
    }
    for (const WarpGrid grid : {WarpGrid::rectilinear, WarpGrid::nonOrthogonal}) {
        const auto wrong = [&](const SceneBuilder& of) {
            return wrongOf(of.scene(), camera, slanted, MapKind::warped, 512, grid);
        };
        const double whole = wrong(coarse), split = wrong(fine);
        std::printf("%.3f %% wrong of a long beam, %.3f %% of a split one\n", whole, split);
        EXPECT_LT(whole, split + 0.1);
    }
}

// Between vertices a paraboloid's edges are straight in the map, but curved in the world.
TEST(Paraboloid, IsWrongOnCoarseTriangles) {
    const RenderSettings settings = maps(MapKind::paraboloid, MapFilter::compare, 1, 1024);
    SceneBuilder builder = SceneBuilder().floor(9);
    builder.box({-6, 2, -0.2f}, {6, 2.1f, 0.2f});
    const double coarse =
        wrongIn(builder.scene(), {{0, 9, 7}, {0, 0, 0}, 60.0}, pointLight({0, 3, 0.5}), settings);
    SceneBuilder fine = SceneBuilder().floor(9);
    for (int i = -30; i < 30; ++i) {
        const float x = 0.2f * static_cast<float>(i);
        fine.box({x, 2, -0.2f}, {x + 0.2f, 2.1f, 0.2f});
    }
    const double split =
        wrongIn(fine.scene(), {{0, 9, 7}, {0, 0, 0}, 60.0}, pointLight({0, 3, 0.5}), settings);
    std::printf("%.3f %% wrong of a long beam, %.3f %% of a split one\n", coarse, split);
    EXPECT_GT(coarse, 3.0 * split);
}

// Reeves et al. 1987: edges become as wide as the filter kernel.
TEST(Pcf, WidensEdgesWithItsKernel) {
    const Scene scene = SceneBuilder().floor(4).box({-1, 1, -1}, {1, 2, 1}).scene();
    const Camera above{{0, 20, 0}, {0, 0, 0}, 20.0};
    int before = 0;
    for (const int width : {1, 3, 5, 7}) {
        const int grey =
            greyPixels(scene, above, slanted, maps(MapKind::cube, MapFilter::compare, width, 128));
        std::printf("%d wide: %d pixels in half shadow\n", width, grey);
        EXPECT_GT(grey, before + (width == 1 ? -1 : 50));
        before = grey;
    }
}

/// A floor completely in the shadow of a low board, and a high board whose edge crosses it.
Scene edgeOverBoard() {
    return SceneBuilder()
        .floor(6)
        .box({-4, 1, -4}, {4, 1.05f, 4})
        .box({-4, 6, -4}, {0, 6.05f, 4})
        .scene();
}
const Camera beneath{{0.2, 0.8, 5.5}, {0, 0, 0}, degrees};

double leakUnderEdge(MapFilter filter, std::optional<float> bleeding = {}) {
    RenderSettings settings = maps(MapKind::cube, filter, 5, 256);
    settings.map.bleeding = bleeding;
    const double leak = leakIn(edgeOverBoard(), beneath, overhead, settings);
    std::printf("%.3f of the light\n", leak);
    return leak;
}

// Donnelly and Lauritzen 2006: where the depths of two casters mix, the bound is loose.
TEST(Vsm, BleedsWhereAnEdgeRunsOverAnotherCaster) {
    EXPECT_LT(leakUnderEdge(MapFilter::compare), 0.001);
    EXPECT_GT(leakUnderEdge(MapFilter::variance, 0.0f), 0.3);
}

// Lauritzen 2007.
TEST(Vsm, BleedsLessWhereSomeOfTheLightIsTakenForIt) {
    const double all = leakUnderEdge(MapFilter::variance, 0.0f);
    const double less = leakUnderEdge(MapFilter::variance);
    EXPECT_LT(less, all - 0.05);
    EXPECT_LT(leakUnderEdge(MapFilter::variance, 0.6f), 0.05);
}

// Peters and Klein 2015: four moments distinguish two casters.
TEST(Msm, BleedsLessThanVsm) {
    const double two = leakUnderEdge(MapFilter::variance, 0.0f);
    EXPECT_LT(leakUnderEdge(MapFilter::moments, 0.0f), 0.2 * two);
}

/// Leak under a board half a unit above a floor, in a map as deep as the height of a post beside
/// it.
double leakUnderBoard(float deep, MapFilter filter) {
    const Scene scene = SceneBuilder()
                            .floor(6)
                            .box({-4, 0.5f, -4}, {4, 0.55f, 4})
                            .box({5, 0, 5}, {5.2f, deep, 5.2f})
                            .scene();
    const double leak = leakIn(scene, {{0, 0.4, 5.5}, {0, 0, 0}, 30.0}, overhead,
                               maps(MapKind::cube, filter, 5, 256));
    std::printf("%.0f deep: %.3f of the light\n", static_cast<double>(deep), leak);
    return leak;
}

// Annen et al. 2008: shadow fades in with the distance behind the caster, as a share of the map's
// depth.
TEST(Esm, LeaksWhereCastersAreNearWhatTheyShade) {
    EXPECT_GT(leakUnderBoard(40, MapFilter::exponential), 0.2);
    EXPECT_LT(leakUnderBoard(40, MapFilter::compare), 0.001);
    EXPECT_LT(leakUnderBoard(3, MapFilter::exponential), 0.001);
}

// But not where an edge crosses another caster that is far enough away.
TEST(Esm, DoesNotBleedWhereVsmDoes) {
    EXPECT_LT(leakUnderEdge(MapFilter::exponential), 0.01);
}

} // namespace
} // namespace edgeshade
