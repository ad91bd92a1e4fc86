// Cascades, paraboloids, warps and filters of shadow maps against ray casting: as close as plain
// maps, and wrong where their authors say so.

#include "preprocess/base/error.hpp"
#include "tests/support/map_pictures.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <ostream>

namespace edgeshade {
namespace {

using test::darkPixels;
using test::drawMask;
using test::maps;
using test::pointLight;
using test::SceneBuilder;
using test::sun;
using test::wrongIn;

constexpr int width = test::mapWidth, height = test::mapHeight;

Scene boxOverFloor() {
    return SceneBuilder().floor(5).box({-1, 0.5f, -1}, {1, 2, 1}).scene();
}
/// The same with a floor of small triangles.
Scene boxOverTiles(const glm::dmat4& placed = glm::dmat4(1.0)) {
    SceneBuilder builder = SceneBuilder().box({-1, 0.5f, -1}, {1, 2, 1});
    for (int i = -10; i < 10; ++i)
        for (int j = -10; j < 10; ++j) {
            const float x = 0.5f * static_cast<float>(i), z = 0.5f * static_cast<float>(j);
            builder.quad({x, 0, z + 0.5f}, {x + 0.5f, 0, z + 0.5f}, {x + 0.5f, 0, z}, {x, 0, z});
        }
    return builder.placedBy(placed).scene();
}
const Camera corner{{5, 4, 6}, {0, 0.5, 0}, 50.0};
const Light lamps[] = {pointLight({1.7, 4, 0.7}), pointLight({7, 4.5, -3})};
const Light suns[] = {sun({0.5, 1, -0.3}), sun({0, 1, 0})};

struct Kind {
    const char* name;
    MapKind kind;
    MapFilter filter;
    int pcf;
    WarpGrid warp = WarpGrid::rectilinear;

    friend void PrintTo(const Kind& of, std::ostream* stream) { *stream << of.name; }
};

class MapKinds : public testing::TestWithParam<Kind> {
  public:
    static RenderSettings settings(int size = 256) {
        return maps(GetParam().kind, GetParam().filter, GetParam().pcf, size, GetParam().warp);
    }
};

TEST_P(MapKinds, BoxOverFloorIsNearlyRight) {
    double wrong = 0.0;
    for (const Light& light : lamps)
        wrong += wrongIn(boxOverTiles(), corner, light, settings(512)) / 4.0;
    for (const Light& light : suns)
        wrong += wrongIn(boxOverFloor(), corner, light, settings(512)) / 4.0;
    std::printf("%s: %.3f %% wrong\n", GetParam().name, wrong);
    EXPECT_LT(wrong, 0.3);
}

// No false shadow where the parts of a map meet.
TEST_P(MapKinds, NothingShadesItself) {
    const Scene floor = SceneBuilder().floor(8, -1).scene();
    for (const Camera& camera :
         {Camera{{0, 9, 0}, {0, -1, 0}, 50.0}, Camera{{3, 1, 4}, {1, -1, 1}, 60.0}})
        for (const Light& light : {pointLight({0, 0, 0}), sun({1, 0.3, 0.2})})
            EXPECT_EQ(darkPixels(drawMask(floor, camera, light, settings(100))), 0)
                << (light.position.w == 0.0 ? "sun" : "lamp");
}

TEST_P(MapKinds, LightInsideAClosedBoxLightsNothingOutside) {
    const auto mask = drawMask(SceneBuilder().floor(6).box({-1, 2, -1}, {1, 4, 1}).scene(),
                               {{6, 9, 8}, {0, 1, 0}, 45.0}, pointLight({0.3, 3, 0.2}), settings());
    int lit = 0;
    for (std::size_t i = 0; i < mask.size(); i += 4)
        lit += mask[i];
    EXPECT_EQ(lit, 0);
}

TEST_P(MapKinds, MirroredStretchedAndFarFromTheOrigin) {
    const glm::dvec3 far(4e6, 123.0, -5e6);
    const glm::dmat4 placed = glm::scale(glm::translate(glm::dmat4(1.0), far), {-1.3, 0.8, 1.1});
    const Scene scene = boxOverTiles(placed); // paraboloids bend the edges of large triangles
    const Camera camera{corner.from + far, corner.to + far, corner.fovDegrees};
    EXPECT_LT(wrongIn(scene, camera, pointLight(glm::dvec3(1.7, 4, 0.7) + far), settings()), 1.5);
    EXPECT_LT(wrongIn(scene, camera, sun({0.5, 1, -0.3}), settings()), 1.5);
}

TEST_P(MapKinds, LightInAFaceAndNothingAtAllAreDrawn) {
    for (const Light& light : {pointLight({0.3, 0, 0.4}), sun({1, 0, 0})})
        EXPECT_EQ(drawMask(boxOverFloor(), corner, light, settings(64)).size(),
                  4u * width * height);
    const auto nothing = drawMask(SceneBuilder().scene(), corner, lamps[0], settings(64));
    EXPECT_EQ(nothing, std::vector<std::uint8_t>(nothing.size(), 0));
}

TEST_P(MapKinds, SmallestMapsAndSeveralLightsTakeTurns) {
    const std::vector<Light> all = {lamps[0], suns[0], suns[1]};
    EXPECT_GT(darkPixels(drawMask(boxOverFloor(), corner, suns[0], settings(16))), 0);
    const auto drawn = test::drawScene(boxOverFloor(), {corner, all, width, height}, settings());
    std::vector<double> sum(drawn.size(), 0.0);
    for (const Light& light : all) {
        const auto one =
            test::drawScene(boxOverFloor(), {corner, {light}, width, height}, settings());
        for (std::size_t i = 0; i < one.size(); ++i)
            sum[i] += one[i] / 3.0;
    }
    for (std::size_t i = 0; i < drawn.size(); i += 4)
        ASSERT_NEAR(drawn[i], sum[i], 3.0);
}

INSTANTIATE_TEST_SUITE_P(
    , MapKinds,
    testing::Values(Kind{"cascades", MapKind::cascades, MapFilter::compare, 1},
                    Kind{"cascadesVsm", MapKind::cascades, MapFilter::variance, 5},
                    Kind{"poisson", MapKind::cube, MapFilter::poisson, 5},
                    Kind{"vsm", MapKind::cube, MapFilter::variance, 5},
                    Kind{"esm", MapKind::cube, MapFilter::exponential, 3},
                    Kind{"msm", MapKind::cube, MapFilter::moments, 5},
                    Kind{"rectilinear", MapKind::warped, MapFilter::compare, 1},
                    Kind{"nonOrthogonalPoisson", MapKind::warped, MapFilter::poisson, 5,
                         WarpGrid::nonOrthogonal},
                    Kind{"paraboloid", MapKind::paraboloid, MapFilter::compare, 1},
                    Kind{"paraboloidPoisson", MapKind::paraboloid, MapFilter::poisson, 5}),
    [](const auto& instance) { return std::string(instance.param.name); });

// Everything else is above: a sun's map covers the casters, not a box around them in the world.
TEST(SunMap, IsFittedToCastersInTheLightsOwnAxes) {
    SceneBuilder builder = SceneBuilder().box({-1, 0.5f, -1}, {1, 2, 1});
    builder.floor(3);
    const Scene scene =
        builder.placedBy(glm::rotate(glm::dmat4(1.0), 0.785398, {0.0, 1.0, 0.0})).scene();
    EXPECT_LT(wrongIn(scene, corner, sun({1, 1.5, 1}), maps(MapKind::cube)), 0.2);
}

/// A floor, a board that hides it from the sun, and one just above the floor, under whose edge
/// light leaks where the map can't resolve it.
Scene boards() {
    return SceneBuilder()
        .floor(6)
        .box({-3, 3, -3}, {3, 3.05f, 3})
        .box({-3, 0.2f, -3}, {0, 0.25f, 3})
        .scene();
}
const Camera below{{0.05, 2.5, 2.5}, {0.05, 0, 0}, 45.0};

int lightUnderBoards(const RenderSettings& settings) {
    const auto picture =
        test::drawScene(boards(), {below, {sun({0, 1, 0})}, width, height, false}, settings);
    int brightest = 0;
    for (std::size_t i = 0; i < picture.size(); i += 4)
        brightest = std::max<int>(brightest, picture[i]);
    return brightest;
}

TEST(Filters, CompareLeavesShadowBehindShadowDark) {
    const int dark = lightUnderBoards(maps(MapKind::cube, MapFilter::compare, 5));
    EXPECT_EQ(lightUnderBoards(maps(MapKind::cube, MapFilter::poisson, 5)), dark);
}

TEST(Filters, AreGreyAtEdgesAndNowhereElse) {
    const Scene scene = SceneBuilder().floor(4).box({-1, 1, -1}, {1, 2, 1}).scene();
    for (const MapFilter filter :
         {MapFilter::poisson, MapFilter::variance, MapFilter::exponential, MapFilter::moments}) {
        const auto pixels = test::drawScene(
            scene, {{{0, 20, 0}, {0, 0, 0}, 20.0}, {sun({0.5, 1, 0.3})}, width, height},
            maps(MapKind::cube, filter, 5, 256));
        int between = 0;
        for (std::size_t p = 0; p < pixels.size(); p += 4)
            between += pixels[p] > 95 && pixels[p] < 190;
        EXPECT_GT(between, 50);
        EXPECT_LT(between, width * height / 8);
    }
}

TEST(Filters, AnUnfilteredWidthIsStillRight) {
    for (const MapFilter filter :
         {MapFilter::poisson, MapFilter::variance, MapFilter::exponential, MapFilter::moments})
        for (const Light& light : {lamps[0], suns[0]})
            EXPECT_LT(wrongIn(boxOverFloor(), corner, light, maps(MapKind::cube, filter, 1)), 1.0);
}

TEST(MapKindsTooLarge, AreUnavailable) {
    try {
        drawMask(boxOverFloor(), corner, suns[0],
                 maps(MapKind::cascades, MapFilter::variance, 5, 1 << 20));
        FAIL() << "should have thrown";
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), ExitStatus::unavailable);
    }
}

} // namespace
} // namespace edgeshade
