// Volumes of single triangles against ray casting: right for any triangle soup, counted behind
// surfaces and in front of them, with the eye in shadow, on any device.

#include "preprocess/base/error.hpp"
#include "src/rivals/brute_force/triangle_draws.hpp"
#include "tests/support/mask_case.hpp"
#include "tests/support/scene_builder.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <random>

namespace edgeshade {
namespace {

using test::Case;
using test::Outcome;
using test::pointLight;
using test::SceneBuilder;
using test::sun;

RenderSettings bruteForce(BruteForceCount count, SidesLayout layout = SidesLayout::instanced) {
    RenderSettings settings;
    settings.multiplicity = MultiplicityMethod::triangle;
    settings.count = count;
    settings.layout = layout;
    return settings;
}

bool instances() {
    static const bool can =
        gl::HeadlessContext(test::testPicture(16, 16)).capabilities().instancing.has_value();
    return can;
}

/// Checks both ways of counting.
void expectBruteForceRight(const Case& test, SidesLayout layout,
                           int mostWrong = test::maskWidth * test::maskHeight / 500) {
    for (const auto count : {BruteForceCount::zFail, BruteForceCount::zPass}) {
        const Outcome outcome = run(test, bruteForce(count, layout));
        const char* const name = count == BruteForceCount::zFail ? "z-fail" : "z-pass";
        EXPECT_EQ(outcome.wrongBeyondOnePixel, 0) << name;
        EXPECT_LE(outcome.wrong, mostWrong) << name;
        EXPECT_GT(outcome.shadow, 50) << name << ": the case should have shadows";
    }
}

/// Checks the layout that the device supports.
void expectBruteForceRight(const Case& test) {
    expectBruteForceRight(test, instances() ? SidesLayout::instanced : SidesLayout::notInstanced);
}

const Camera corner{{5, 4, 6}, {0, 0.5, 0}, 50.0};

Scene boxOverFloor() {
    return SceneBuilder().floor(5).box({-1, 0.5f, -1}, {1, 2, 1}).scene();
}

TEST(BruteForce, BoxesSheetsAndATriangleInLampAndSun) {
    for (const Light& light : {pointLight({1.7, 4, 0.7}), sun({0.5, 1, -0.3})}) {
        const Case test{test::yard().scene(), corner, light};
        expectBruteForceRight(test, SidesLayout::notInstanced);
        if (instances()) expectBruteForceRight(test, SidesLayout::instanced);
    }
}

TEST(BruteForce, SunStraightAbove) {
    const SceneBuilder sheet =
        SceneBuilder().floor(5).quad({-1, 1, 1}, {1, 1.2f, 1}, {1, 1.2f, -1}, {-1, 1, -1});
    expectBruteForceRight({sheet.scene(), corner, sun({0, 1, 0})});
}

TEST(BruteForce, AnEdgeWithManyTriangles) {
    SceneBuilder builder = SceneBuilder().floor(6);
    for (int i = 0; i < 9; ++i) {
        const float angle = 0.7f * static_cast<float>(i);
        builder.triangle({0, 0.5f, 0}, {0, 2.5f, 0},
                         {2 * std::cos(angle), 1.5f, 2 * std::sin(angle)});
    }
    for (const Light& light : {pointLight({0.3, 5, 0.4}), sun({0.3, 1, 0.2})})
        expectBruteForceRight({builder.scene(), corner, light});
}

/// Unrelated triangles, some of them slivers.
Scene soup(bool slivers) {
    std::mt19937 random(7);
    const auto unit = [&] { return static_cast<float>(random()) / 4294967296.0f; };
    const auto place = [&] { return glm::vec3(4 * unit() - 2, 0.3f + 2 * unit(), 4 * unit() - 2); };
    SceneBuilder builder = SceneBuilder().floor(6);
    for (int i = 0; i < 60; ++i) {
        const glm::vec3 a = place(), b = place();
        const glm::vec3 c =
            slivers ? a + 0.5f * (b - a) + glm::vec3(0, 1e-5f, 2e-5f) : a + 0.6f * (place() - a);
        builder.triangle(a, a + 0.6f * (b - a), c);
    }
    return builder.scene();
}

TEST(BruteForce, ASoupOfTriangles) {
    for (const Light& light : {pointLight({0.3, 5, 0.4}), sun({0.3, 1, 0.2})})
        expectBruteForceRight({soup(false), {{4, 5, 5}, {0, 0, 0}, 50.0}, light},
                              instances() ? SidesLayout::instanced : SidesLayout::notInstanced,
                              150);
}

// Slivers without neighbours: no streaks, and hardly any shadow.
TEST(BruteForce, SliversLeaveNoStreaks) {
    const Case test{soup(true), {{4, 5, 5}, {0, 0, 0}, 50.0}, pointLight({0.3, 5, 0.4})};
    for (const auto count : {BruteForceCount::zFail, BruteForceCount::zPass}) {
        const Outcome outcome = run(test, bruteForce(count, SidesLayout::notInstanced));
        EXPECT_LE(outcome.wrongBeyondOnePixel, 4); // 3 with a 16-bit depth buffer
        EXPECT_LE(outcome.wrong, 60);
    }
}

// Within a wall two triangles' sides begin at the visible surface: they cancel only if both have
// the same depths there. Tested with a wall inside the picture, and with one that clipping gives
// other vertices.
TEST(BruteForce, NeighboursSidesCancelAtTheSurface) {
    for (const float half : {3.6f, 9.0f}) {
        const Scene wall =
            SceneBuilder()
                .quad({-half, -half, -6}, {half, -half, -6}, {half, half, -6}, {-half, half, -6})
                .scene();
        for (const auto count : {BruteForceCount::zFail, BruteForceCount::zPass})
            for (const Light& light : {sun({0, 1, 1}), sun({0.3, 1, 0.1}), pointLight({1, 2, 3})}) {
                const Outcome outcome = test::run({wall, {{0, 0, 1}, {0, 0, -6}, 70.0}, light},
                                                  bruteForce(count, SidesLayout::notInstanced));
                EXPECT_EQ(outcome.wrong, 0) << half;
            }
    }
}

// A roof over the eye, so that the near plane starts within its volume.
TEST(BruteForce, EyeInShadow) {
    const Scene scene = SceneBuilder()
                            .floor(8)
                            .box({-2, 3, -2}, {2, 3.3f, 2})
                            .box({-0.4f, 0.3f, -3}, {0.4f, 1, -2.4f})
                            .scene();
    for (const Camera& camera :
         {Camera{{0.3, 1.5, 0.4}, {0, 0.4, -4}, 60.0}, Camera{{1.9, 1.5, 0.4}, {0, 0.4, -6}, 75.0}})
        for (const Light& light : {pointLight({0.5, 6, 0.8}), pointLight({0.5, 6, -1.8}),
                                   sun({0.2, 1, 0.3}), sun({0.2, 1, -0.3})})
            expectBruteForceRight({scene, camera, light});
}

// The light beyond the near plane, with casters in between, and behind the eye.
TEST(BruteForce, EyeInTheShadowOfWhatIsAhead) {
    const Scene scene =
        SceneBuilder().floor(9).quad({-1, 0, -3}, {1, 0, -3}, {1, 3, -3}, {-1, 3, -3}).scene();
    expectBruteForceRight({scene, {{0.2, 1, 2}, {1, 0.2, -1}, 80.0}, pointLight({0, 2, -5})});
    expectBruteForceRight({scene, {{0.2, 1, -4}, {1, 0.2, -9}, 80.0}, pointLight({0, 2, 3})});
}

// A caster through the near plane, with the eye on either side of it.
TEST(BruteForce, ACasterThroughTheNearPlane) {
    const Scene scene = SceneBuilder().floor(8).box({-3, 1.8f, -3}, {3, 2, 0.9f}).scene();
    for (const double y : {1.5, 2.6})
        for (const Light& light : {pointLight({1, 5, -0.5}), sun({0.1, 1, 0.4})})
            expectBruteForceRight({scene, {{0.3, y, 1}, {0, 0, -4}, 80.0}, light, 0.5});
}

// As seen from the near plane the light's rays lie in it: ZP+ doesn't work then, and the report
// says so.
TEST(BruteForce, LightInTheNearPlaneIsCountedBehindSurfaces) {
    const Scene scene = SceneBuilder().floor(8).box({-3, 2, -3}, {3, 2.2f, 3}).scene();
    for (const Light& light : {sun({0, 1, 0}), sun({0.2, 1, 1e-4}), pointLight({0, 5, 0.9})})
        expectBruteForceRight({scene, {{0.3, 1.2, 1}, {0.3, 1.2, -4}, 70.0}, light, 0.1});
}

TEST(BruteForce, DepthSlicesEachHaveANearPlane) {
    Case test{boxOverFloor(), {{0, 1, 6}, {0, 0.8, 0}, 60.0}, pointLight({0.5, 4, -2})};
    test.slices = 3;
    expectBruteForceRight(test);
}

TEST(BruteForce, MirroredStretchedAndFarFromTheOrigin) {
    const glm::dvec3 far(4e6, 123.0, -5e6);
    const glm::dmat4 placed = glm::scale(glm::translate(glm::dmat4(1.0), far), {-1.3, 0.8, 1.1});
    const Scene scene =
        SceneBuilder().floor(5).box({-1, 0.5f, -1}, {1, 2, 1}).placedBy(placed).scene();
    const Camera camera{corner.from + far, corner.to + far, corner.fovDegrees};
    expectBruteForceRight({scene, camera, pointLight(glm::dvec3(1.7, 4, 0.7) + far)});
    expectBruteForceRight({scene, camera, sun({0.5, 1, -0.3})});
}

// So many triangles behind each other that eight bits would count them as 0: they are split into
// groups.
TEST(BruteForce, MoreLayersThanTheStencilCounts) {
    SceneBuilder builder = SceneBuilder().floor(5);
    for (int i = 0; i < 256; ++i) {
        const float y = 0.5f + 0.005f * static_cast<float>(i);
        builder.triangle({-1, y, -1}, {-1, y, 1}, {1, y, 0});
    }
    expectBruteForceRight({builder.scene(), corner, pointLight({0.1, 6, 0.2})});
}

// Cutouts: the whole polygon casts, and surfaces behind its holes are visible through it.
TEST(BruteForce, AlphaTestedCasters) {
    Material hole;
    hole.alphaMode = AlphaMode::mask;
    hole.alphaCutoff = 0.5f;
    hole.baseColorFactor.a = 0.2f;
    Case test{SceneBuilder()
                  .floor(5)
                  .material(hole)
                  .quad({-1, 1, 1}, {1, 1, 1}, {1, 1.5f, -1}, {-1, 1.5f, -1})
                  .scene(),
              {{0, 4, 5}, {0, 0.5, 0}, 50.0},
              pointLight({0.4, 5, 0.3})};
    test.castMasked = true;
    expectBruteForceRight(test);
}

TEST(BruteForce, OrthographicAndCulledPicturesAreUnavailable) {
    Case test{boxOverFloor(), corner, sun({0.5, 1, -0.3})};
    test.scene.culls = true;
    EXPECT_THROW(run(test, bruteForce(BruteForceCount::zFail, SidesLayout::notInstanced)), Error);
}

/// One batch with two materials, the second alpha-tested.
std::vector<VolumeDraw> drawsOf(const TriangleCount& count) {
    Material opaque, masked;
    masked.alphaMode = AlphaMode::mask;
    std::vector<VolumeDraw> draws;
    appendTriangleDraws({{0, 0, 3}, {0, 3, 4}, {1, 7, 2}}, 5, count, {opaque, masked}, draws);
    return draws;
}

TEST(TriangleDraws, BehindSurfacesAreWholeVolumes) {
    using Shape = VolumeDraw::Shape;
    const auto draws = drawsOf({.nearDiscard = true});
    ASSERT_EQ(draws.size(), 4u);
    EXPECT_EQ(draws[0].range.count, 7u); // merged adjoining opaque ranges
    EXPECT_EQ(draws[0].verticesPerRecord, 18);
    EXPECT_TRUE(draws[0].zFail && draws[0].nearDiscard && draws[0].batch == 5);
    EXPECT_EQ(draws[0].shape, Shape::triangleVolumes);
    EXPECT_EQ(draws[1].shape, Shape::negativeSides);
    EXPECT_EQ(draws[1].range.count, 7u);
    EXPECT_EQ(draws[1].verticesPerRecord, 12);
    EXPECT_EQ(draws[2].alphaTested, 1u);
    EXPECT_EQ(draws[2].verticesPerRecord, 21);
    EXPECT_EQ(draws[3].verticesPerRecord, 12);
    EXPECT_EQ(drawsOf({.directional = true})[0].verticesPerRecord, 9);
    EXPECT_EQ(drawsOf({.directional = true})[1].verticesPerRecord, 6);
}

TEST(TriangleDraws, BeforeSurfacesAreNearCapsAndSides) {
    using Shape = VolumeDraw::Shape;
    const auto draws = drawsOf({.zFail = false, .nearDiscard = true});
    std::vector<Shape> shapes;
    for (const VolumeDraw& draw : draws) {
        EXPECT_FALSE(draw.zFail || draw.nearDiscard);
        shapes.push_back(draw.shape);
    }
    EXPECT_EQ(shapes,
              (std::vector<Shape>{Shape::nearCaps, Shape::triangleVolumes, Shape::negativeSides,
                                  Shape::nearCaps, Shape::triangleVolumes, Shape::negativeSides,
                                  Shape::caps}));
    EXPECT_EQ(draws[1].verticesPerRecord, 12);
    EXPECT_TRUE(draws[6].cutoutsAlone);
    EXPECT_EQ(drawsOf({.zFail = false, .directional = true})[1].verticesPerRecord, 6);
}

} // namespace
} // namespace edgeshade
