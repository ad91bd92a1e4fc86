// Scenes that cull: backs of single-sided materials are invisible, but still cast (docs/method.md,
// C39).

#include "tests/support/hard_lights.hpp"
#include "tests/support/mask_case.hpp"
#include "tests/support/scene_builder.hpp"

#include <array>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::Case;
using test::Outcome;
using test::pointLight;
using test::Random;
using test::SceneBuilder;
using test::sun;

Scene culling(const SceneBuilder& builder) {
    Scene scene = builder.scene();
    scene.culls = true;
    return scene;
}

/// Limit on wrong pixels away from boundaries: at contacts that a 16-bit depth buffer doesn't
/// resolve, or where hardware rounds depths in its own way.
int allowance() {
    if (test::testLimits() != gl::Limits::device) return 2;
    return test::drawsOnProcessor() ? 0 : 1;
}

/// Checks volumes of every layout, and a primitive map if the GL supports it.
void expectCulledRight(const Case& test) {
    for (const auto layout : {SidesLayout::instanced, SidesLayout::notInstanced}) {
        RenderSettings settings;
        settings.layout = layout;
        const Outcome outcome = test::run(test, settings);
        EXPECT_LE(outcome.wrongBeyondOnePixel, allowance()) << outcome.where;
        EXPECT_LE(outcome.wrong, test::maskWidth * test::maskHeight / 500);
        EXPECT_GT(outcome.shadow, 50) << "the case should have shadows";
    }
    if (test::testLimits() == gl::Limits::device && !test.castMasked)
        test::expectLookedUpRight(test);
}

Material doubleSided() {
    Material material;
    material.doubleSided = true;
    return material;
}

/// A room that is visible only from inside, with a stool, on a ground around it.
SceneBuilder room() {
    return SceneBuilder()
        .floor(6, -0.1f)
        .box({2, 2, 2}, {-2, 0, -2})
        .box({-0.5f, 0.4f, -0.5f}, {0.5f, 0.8f, 0.5f})
        .quad({-1.5f, 1, -1}, {-0.7f, 1, -1}, {-0.7f, 1.6f, -1.2f}, {-1.5f, 1.6f, -1.2f});
}

const Camera outside{{6, 5, 7}, {0, 0.6, 0}, 45.0};
const Camera inside{{1.7, 1.6, 1.8}, {-0.5, 0.3, -0.5}, 75.0};

TEST(Culling, ARoomFromOutsideShowsItsInside) {
    for (const Light& light : {pointLight({0.9, 1.7, 0.8}), pointLight({3, 4, 1}),
                               sun({0.5, 1, -0.3}), pointLight({-0.2, 0.2, 0.3})})
        expectCulledRight({culling(room()), outside, light});
}

TEST(Culling, ARoomFromInside) {
    for (const Light& light :
         {pointLight({0.9, 1.7, 0.8}), pointLight({3, 4, 1}), sun({0.5, 1, -0.3})})
        expectCulledRight({culling(room()), inside, light});
}

TEST(Culling, ABoxFromInsideIsNotSeenAndShadesWhatIs) {
    const SceneBuilder builder =
        SceneBuilder().floor(6).box({-1, 0.3f, -1}, {1, 2, 1}).box({2, 0.2f, 1}, {3, 1, 2});
    for (const Light& light : {pointLight({0.4, 1.2, 0.3}), pointLight({0.5, 5, 0.3}),
                               sun({0.5, 1, -0.3}), pointLight({3, 3, -2})})
        expectCulledRight({culling(builder), {{0.8, 1.7, 0.7}, {1.5, 0.3, 2}, 80.0}, light});
}

TEST(Culling, ABoxFromOutsideIsAsItWas) {
    const SceneBuilder builder = SceneBuilder().floor(6).box({-1, 0.3f, -1}, {1, 2, 1});
    for (const Light& light :
         {pointLight({0.4, 1.2, 0.3}), pointLight({0.5, 5, 0.3}), sun({0.5, 1, -0.3})})
        expectCulledRight({culling(builder), outside, light});
}

TEST(Culling, SheetsThatAreTurnedAway) {
    // Three of them, one behind the other, and a floor.
    SceneBuilder builder = SceneBuilder().floor(5);
    for (const float z : {-1.0f, 0.2f, 1.5f})
        builder.quad({1, 0.2f, z}, {-1.2f, 0.3f, z}, {-1, 2, z + 0.3f}, {1.1f, 1.8f, z});
    const Camera camera{{0.8, 2.5, 6}, {0, 0.6, 0}, 45.0};
    for (const Light& light :
         {pointLight({0.3, 1.6, 0.7}), pointLight({0.2, 2, 4}), pointLight({-0.5, 2.2, -4}),
          sun({0.3, 0.5, 1}), sun({0.3, 0.5, -1})})
        expectCulledRight({culling(builder), camera, light});
}

// The purpose of C39: if only the surfaces are culled, volumes shade what is behind them.
TEST(Culling, SurfacesAloneAreNotEnough) {
    const Case test{culling(room()), outside, pointLight({0.9, 1.7, 0.8})};
    EXPECT_GT(test::run(test, {}, true, false).wrongBeyondOnePixel, 1000);
    EXPECT_LE(test::run(test).wrongBeyondOnePixel, allowance());
}

TEST(Culling, SheetsBackToBackHaveNoThickness) {
    // Walls of two coinciding sheets each, of different or the same triangles.
    SceneBuilder builder = SceneBuilder().floor(5);
    const auto wall = [&](glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d, bool otherwise) {
        builder.quad(a, b, c, d);
        if (otherwise)
            builder.quad(c, b, a, d);
        else
            builder.quad(b, a, d, c);
    };
    wall({-2, 0, 0.3f}, {0.1f, 0, -0.6f}, {0.1f, 1.5f, -0.6f}, {-2, 1.5f, 0.3f}, false);
    wall({0.5f, 0, 1}, {2.3f, 0, 0.1f}, {2.3f, 1.2f, 0.1f}, {0.5f, 1.2f, 1}, true);
    wall({-1, 1.7f, 1}, {1, 1.8f, 1}, {1, 1.8f, -1.3f}, {-1, 1.7f, -1.3f}, false);
    for (const Camera& camera :
         {Camera{{1.5, 3, 6}, {0, 0.6, 0}, 45.0}, Camera{{1.5, 0.7, -5}, {0, 0.8, 0}, 45.0},
          Camera{{3, 0.4, 4}, {0, 1, 0}, 45.0}})
        for (const Light& light : {pointLight({0.3, 2.6, 2.7}), pointLight({0.2, 1, -3}),
                                   sun({0.3, 0.8, 0.5}), sun({0.4, 0.6, -0.5})})
            expectCulledRight({culling(builder), camera, light});
}

TEST(Culling, MirroredAndShearedNodes) {
    glm::dmat4 placed = glm::scale(glm::dmat4(1.0), {-1.0, 0.8, 1.1});
    placed[1][0] = 0.3;
    for (const Light& light : {pointLight({-0.9, 1.3, 0.8}), sun({0.5, 1, -0.3})})
        expectCulledRight({culling(room().placedBy(placed)), outside, light});
}

TEST(Culling, SinglesAndDoublesInOneMesh) {
    // An open box whose walls alternate between the two kinds, joined at their edges; and a closed
    // one turned inside out.
    SceneBuilder builder = SceneBuilder().floor(6, -0.2f);
    const glm::vec3 low(-1.5f, 0, -1.5f), high(1.5f, 1.4f, 1.5f);
    const auto corner = [&](int i) {
        return glm::vec3(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z);
    };
    builder.quad(corner(0), corner(4), corner(6), corner(2));
    builder.quad(corner(0), corner(1), corner(5), corner(4));
    builder.material(doubleSided());
    builder.quad(corner(1), corner(3), corner(7), corner(5));
    builder.material(Material());
    builder.quad(corner(5), corner(7), corner(6), corner(4));
    builder.material(doubleSided());
    builder.quad(corner(0), corner(2), corner(3), corner(1));
    builder.material(Material());
    builder.box({3.5f, 1, 1}, {2, 0, -1});
    for (const Camera& camera : {outside, Camera{{-5, 4, 6}, {0, 0.6, 0}, 45.0},
                                 Camera{{0, 1, 0.5}, {1.3, 0.2, -2}, 80.0}})
        for (const Light& light :
             {pointLight({0.9, 1.1, 0.8}), pointLight({3, 3, 2}), sun({-0.5, 1, -0.6})})
            expectCulledRight({culling(builder), camera, light});
}

TEST(Culling, AlphaTestedCasters) {
    Material solid;
    solid.alphaMode = AlphaMode::mask;
    solid.baseColorFactor.a = 0.75f;
    Material holes = solid;
    holes.baseColorFactor.a = 0.25f;
    SceneBuilder builder = SceneBuilder().floor(5);
    builder.material(solid).box({1.8f, 1.6f, 1.2f}, {0.2f, 0.1f, -0.8f});
    builder.material(holes).box({-0.4f, 1.5f, 1}, {-1.6f, 0.2f, -1});
    for (const Light& light :
         {pointLight({1, 1.2, 0.3}), pointLight({0, 4, 1}), sun({0.4, 0.9, -0.5})}) {
        Case test{culling(builder), outside, light};
        test.castMasked = true;
        expectCulledRight(test);
    }
}

TEST(Culling, TheNearPlaneWithinARoom) {
    Case test{
        culling(room()), {{2.4, 1.9, 2.6}, {-0.5, 0.3, -0.5}, 75.0}, pointLight({0.9, 1.7, 0.8})};
    for (const double near : {0.05, 0.5, 1.2}) {
        test.near = near;
        expectCulledRight(test);
    }
}

TEST(Culling, DepthSlices) {
    Case test{culling(room()), outside, pointLight({0.9, 1.7, 0.8})};
    for (const int slices : {2, 5}) {
        test.slices = slices;
        for (const Light& light : {pointLight({0.9, 1.7, 0.8}), sun({0.5, 1, -0.3})}) {
            test.light = light;
            expectCulledRight(test);
        }
    }
}

TEST(Culling, OrthographicPictures) {
    for (const Light& light : {sun({0.5, 1, -0.3}), sun({-0.2, 1, 0.9}), pointLight({0.9, 5, 9})}) {
        Case test{culling(room()), outside, light};
        test.frustum = frustumOf(outside, 4.0 / 3.0, 7.0);
        expectCulledRight(test);
    }
}

/// Closed components that cross themselves and each other, single- or double-sided.
SceneBuilder randomShells(Random& random) {
    SceneBuilder builder = SceneBuilder().material(doubleSided()).floor(5, -1.5f);
    for (int shell = 0; shell < 4; ++shell) {
        const int mixed = random.below(3);
        std::array<glm::vec3, 6> p;
        for (glm::vec3& corner : p)
            corner = glm::vec3(1.4 * random.inCube());
        constexpr int faces[8][3] = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                     {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
        for (const bool both : {false, true}) {
            builder.material(both ? doubleSided() : Material());
            for (int f = 0; f < 8; ++f)
                if (both == (mixed == 0 && f % 3 == 0))
                    builder.triangle(p[faces[f][0]], p[faces[f][1]], p[faces[f][2]]);
        }
    }
    return builder;
}

TEST(Culling, RandomShellsAreRight) {
    Random random(39);
    int shadowed = 0, wrong = 0;
    for (int i = 0; i < 60; ++i) {
        const Scene scene = culling(randomShells(random));
        const bool within = random.below(3) == 0;
        const glm::dvec3 eye = (within ? 0.9 : 4.0) * random.inCube();
        const glm::dvec3 light = (random.below(2) == 0 ? 1.0 : 4.0) * random.inCube();
        const Case test{scene,
                        {eye, 0.5 * random.inCube(), 60.0},
                        random.below(3) == 0 ? sun(light) : pointLight(light)};
        const Outcome outcome = test::run(test);
        wrong += outcome.wrongBeyondOnePixel;
        EXPECT_LE(outcome.wrong, test::maskWidth * test::maskHeight / 200) << "scene " << i;
        shadowed += outcome.shadow > 0 && outcome.lit > 0;
    }
    EXPECT_GT(shadowed, 20);
    // Shells cross each other: where a culled one meets a visible one, a pixel may show either.
    EXPECT_LE(wrong, test::testLimits() == gl::Limits::device ? 3 : 20) << "of 60 masks";
}

} // namespace
} // namespace edgeshade
