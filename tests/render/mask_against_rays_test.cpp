// Masks against ray casting in double: every pixel away from a boundary must agree.

#include "tests/support/mask_case.hpp"
#include "tests/support/scene_builder.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <random>

namespace edgeshade {
namespace {

using test::Answer;
using test::Case;
using test::expectRight;
using test::Outcome;
using test::pointLight;
using test::run;
using test::SceneBuilder;
using test::sun;
using test::yard;

constexpr int width = test::maskWidth, height = test::maskHeight;

const Camera corner{{5, 4, 6}, {0, 0.5, 0}, 50.0};

TEST(MaskAgainstRays, PointLightAboveTheYard) {
    expectRight({yard().scene(), corner, pointLight({0.3, 4, 0.7})});
}

TEST(MaskAgainstRays, SunOverTheYard) {
    expectRight({yard().scene(), corner, sun({0.5, 1, -0.3})});
}

TEST(MaskAgainstRays, LightBetweenTheObjects) {
    expectRight({yard().scene(), corner, pointLight({-0.4, 1.1, 0.9})});
}

TEST(MaskAgainstRays, EyeInsideAShadow) {
    // Under the box at (-2..-1, 0.5..2, -1..0), looking along the floor.
    expectRight(
        {yard().scene(), {{-1.5, 0.2, -0.5}, {1, 0.3, 1}, 70.0}, pointLight({-1.4, 5, -0.4})});
}

TEST(MaskAgainstRays, EyeOutsideWhereItSeesTheGroundThroughAShadow) {
    // The shadow rises from the floor towards the eye, and lies in front of it outside all visible
    // geometry.
    expectRight({SceneBuilder().floor(2).box({-0.5f, 0.2f, -0.5f}, {0.5f, 1, 0.5f}).scene(),
                 {{12, 4, 0}, {0, 0.3, 0}, 25.0},
                 pointLight({-5, 1.2, 0})});
}

TEST(MaskAgainstRays, LookingIntoTheLight) {
    expectRight({yard().scene(), {{0, 0.3, 4}, {0.3, 2, 0}, 60.0}, pointLight({0.3, 2.5, -1})});
}

TEST(MaskAgainstRays, LightBelowTheFloorLightsNothingAbove) {
    const Outcome outcome = run({yard().scene(), corner, pointLight({0.3, -2, 0.7})});
    EXPECT_EQ(outcome.wrongBeyondOnePixel, 0);
    EXPECT_EQ(outcome.lit, 0);
}

// Method, section 5: a caster crosses the near plane; its front cap, moved to infinity, must not
// count where the caster was clipped.
Case casterThroughTheNearPlane() {
    const auto scene =
        SceneBuilder().floor(8).triangle({-1, 1.5f, 4.5f}, {1.2f, 1.4f, 4.4f}, {0.1f, 1.1f, -1});
    return {scene.scene(), {{0, 2, 6}, {0, 0.8, 0}, 60.0}, pointLight({0.4, 3, 0.5}), 3.0};
}

TEST(MaskAgainstRays, CasterThroughTheNearPlane) {
    expectRight(casterThroughTheNearPlane());
}

TEST(MaskAgainstRays, CasterThroughTheNearPlaneNeedsTheDiscard) {
    RenderSettings published;
    published.multiplicity = MultiplicityMethod::referenceEdge;
    EXPECT_GT(run(casterThroughTheNearPlane(), published, false).wrongBeyondOnePixel, 100);
}

TEST(MaskAgainstRays, ClosedCasterThroughTheNearPlane) {
    const auto scene = SceneBuilder().floor(8).box({-1, 1, 1}, {1, 1.6f, 5});
    expectRight(
        {scene.scene(), {{0.2, 2.4, 6.5}, {0, 0.6, 0}, 60.0}, pointLight({0.4, 4, 0.5}), 3.0});
}

TEST(MaskAgainstRays, MirroredNode) {
    expectRight({yard().placedBy(glm::scale(glm::dmat4(1.0), {-1.0, 1.0, 1.0})).scene(), corner,
                 pointLight({0.3, 4, 0.7})});
}

TEST(MaskAgainstRays, StretchedAndShearedNode) {
    glm::dmat4 shear(1.0);
    shear[1][0] = 0.5;
    expectRight({yard().placedBy(glm::scale(shear, {1.3, 0.6, 0.9})).scene(), corner,
                 pointLight({0.3, 4, 0.7})});
}

TEST(MaskAgainstRays, FarFromTheOrigin) {
    const glm::dvec3 far(4e6, 123.0, -5e6);
    Case test{yard().placedBy(glm::translate(glm::dmat4(1.0), far)).scene(), corner,
              pointLight(glm::dvec3(0.3, 4, 0.7) + far)};
    test.camera.from += far;
    test.camera.to += far;
    expectRight(test);
}

TEST(MaskAgainstRays, FanOfTwelveTrianglesAroundOneEdge) {
    // More opposite vertices than a record can hold, so that the edge is split.
    SceneBuilder builder = SceneBuilder().floor(6);
    for (int i = 0; i < 12; ++i) {
        const float angle = 0.5f * static_cast<float>(i) + 0.1f;
        builder.triangle({0, 0.5f, 0}, {0, 2, 0}, {2 * std::cos(angle), 1, 2 * std::sin(angle)});
    }
    expectRight({builder.scene(), corner, pointLight({1.3, 4, 0.4})});
}

/// Open roofs over a floor, whose ridge counts twice for light from the side, and upright sheets
/// between the eyes and such lights, so that the count starts at their number.
SceneBuilder roofsBehindSheets(int sheets) {
    SceneBuilder builder;
    builder.floor(6);
    for (const float x : {-2.5f, -0.5f, 1.5f}) {
        builder.quad({x, 0.4f, 1}, {x + 0.6f, 1.3f, 1}, {x + 0.6f, 1.3f, -1}, {x, 0.4f, -1});
        builder.quad({x + 0.6f, 1.3f, 1}, {x + 1, 0.3f, 1}, {x + 1, 0.3f, -1},
                     {x + 0.6f, 1.3f, -1});
    }
    for (int i = 0; i < sheets; ++i) {
        const float x = 7.0f + 0.2f * static_cast<float>(i);
        builder.quad({x, 3.5f, 5}, {x, 3.5f, 8}, {x, 6.5f, 8}, {x, 6.5f, 5});
    }
    return builder;
}

TEST(MaskAgainstRays, SidesThatCountTwiceFromEyesWithinVolumes) {
    const glm::dmat4 mirror = glm::scale(glm::dmat4(1.0), glm::dvec3(1, 1, -1));
    const double near = 0.05; // so small a rectangle is completely in the sheets' shadow
    for (const int sheets : {0, 1, 2, 3})
        for (const Light& light : {sun({1, 0.6, 0.4}), pointLight({14, 9, 9})}) {
            expectRight(
                {roofsBehindSheets(sheets).scene(), {{4, 3, 5}, {0, 0.4, 0}, 50.0}, light, near});
            Light mirrored = light;
            mirrored.position.z *= -1.0;
            expectRight({roofsBehindSheets(sheets).placedBy(mirror).scene(),
                         {{4, 3, -5}, {0, 0.4, 0}, 50.0},
                         mirrored,
                         near});
        }
}

// A roof crosses the near plane: its sides are counted behind surfaces, by twos.
TEST(MaskAgainstRays, SidesThatCountTwiceBehindSurfaces) {
    for (const double near : {2.0, 3.0, 4.0})
        expectRight({roofsBehindSheets(1).scene(),
                     {{3, 2, 4}, {0, 0.6, 0}, 60.0},
                     sun({1, 0.9, 0.3}),
                     near});
}

TEST(MaskAgainstRays, TriangleSoup) {
    std::mt19937 random(11);
    std::uniform_real_distribution<float> uniform(-2.0f, 2.0f);
    const auto point = [&] {
        const float x = uniform(random), y = uniform(random), z = uniform(random);
        return glm::vec3(x, 2.5f + y, z);
    };
    SceneBuilder builder = SceneBuilder().floor(6);
    for (int i = 0; i < 30; ++i) {
        const glm::vec3 a = point(), b = point(), c = point();
        builder.triangle(a, b, c);
    }
    // Lines where triangles pierce each other are not boundaries of the answer: a few pixels there
    // show the other triangle.
    const Case test{builder.scene(), corner, pointLight({0.5, 6, 0.2})};
    const Outcome outcome = run(test);
    EXPECT_LE(outcome.wrongBeyondOnePixel, 3);
    EXPECT_LE(outcome.wrong, width * height / 200);
}

/// The yard with a tiny object just in front of the eye and the whole scene behind it.
Case deepView(std::optional<int> slices) {
    SceneBuilder builder = yard();
    builder.triangle({4.99f, 3.993f, 5.99f}, {4.991f, 3.993f, 5.99f}, {4.9905f, 3.9935f, 5.9901f});
    return {builder.scene(), corner, pointLight({0.3, 4, 0.7}), 0.001, false, slices};
}

TEST(MaskAgainstRays, DepthSlicesChangeNothingButPrecision) {
    for (const int slices : {2, 3, 7})
        expectRight(deepView(slices));
}

TEST(MaskAgainstRays, DepthSlicesAreChosenForADeepView) {
    expectRight(deepView(std::nullopt));
}

TEST(MaskAgainstRays, CasterThroughTheNearPlaneOfSlices) {
    Case test = casterThroughTheNearPlane();
    test.slices = 4;
    expectRight(test);
}

/// Sheets above one another over a floor that the eye sees beside them.
Case stack(int sheets) {
    SceneBuilder builder = SceneBuilder().floor(6);
    for (int i = 0; i < sheets; ++i) {
        const float y = 1.0f + 1.5f * static_cast<float>(i) / static_cast<float>(sheets);
        builder.quad({-1, y, 1}, {1, y, 1}, {1, y, -1}, {-1, y, -1});
    }
    return {builder.scene(), corner, pointLight({0.6, 7, 0.3})};
}

// 256 layers of volumes around a point wrap an 8-bit stencil to 0, which would mean lit.
TEST(MaskAgainstRays, MoreLayersThanTheStencilCounts) {
    for (const int sheets : {255, 256, 257, 512, 1000}) {
        const Outcome outcome = run(stack(sheets));
        EXPECT_EQ(outcome.wrongBeyondOnePixel, 0) << sheets << " sheets";
        EXPECT_GT(outcome.shadow, 1000);
    }
}

TEST(MaskAgainstRays, LayersOfCastersWithHolesAreCountedToo) {
    Material material;
    material.alphaMode = AlphaMode::mask;
    SceneBuilder builder = SceneBuilder().floor(6).material(material);
    for (int i = 0; i < 256; ++i) {
        const float y = 1.0f + 0.005f * static_cast<float>(i);
        builder.quad({-1, y, 1}, {1, y, 1}, {1, y, -1}, {-1, y, -1});
    }
    EXPECT_EQ(
        run({builder.scene(), corner, pointLight({0.6, 7, 0.3}), 0.0, true}).wrongBeyondOnePixel,
        0);
}

/// A floor and a sheet above it with this alpha mode.
Case sheetOf(AlphaMode mode, float alpha, bool castMasked) {
    Material material;
    material.alphaMode = mode;
    material.baseColorFactor.a = alpha;
    SceneBuilder builder = SceneBuilder().floor(5).box({1, 0, 1}, {2, 1, 2}).material(material);
    builder.quad({-1.5f, 1.5f, 1}, {1.5f, 1.5f, 1}, {1.5f, 1.7f, -1}, {-1.5f, 1.7f, -1});
    return {builder.scene(), corner, pointLight({0.3, 4, 0.7}), 0.0, castMasked};
}

TEST(MaskAgainstRays, WhatIsNotOpaqueDoesNotCast) {
    for (const bool visible : {true, false}) {
        const Outcome outcome = run(sheetOf(AlphaMode::mask, visible ? 1.0f : 0.0f, false));
        EXPECT_EQ(outcome.wrongBeyondOnePixel, 0);
    }
    EXPECT_EQ(run(sheetOf(AlphaMode::blend, 0.5f, false)).wrongBeyondOnePixel, 0);
}

TEST(MaskAgainstRays, MaskedCasterIsRightInFrontOfAndBehindItsHoles) {
    expectRight(sheetOf(AlphaMode::mask, 1.0f, true));
    expectRight(sheetOf(AlphaMode::mask, 0.0f, true)); // all hole: the floor is visible through it
}

TEST(MaskAgainstRays, BlendedCasterCastsThoughItIsNotInTheDepthBuffer) {
    expectRight(sheetOf(AlphaMode::blend, 0.5f, true));
}

TEST(MaskAgainstRays, SeveralBatches) {
    Scene scene = yard().scene();
    Scene turned = SceneBuilder().box({-0.5f, 1.5f, -0.5f}, {0.5f, 2, 0.5f}).scene();
    turned.batches[0].worldFromBatch =
        glm::rotate(glm::translate(glm::dmat4(1.0), {1.5, 0.5, 0}), 0.7, {1.0, 2.0, 0.5});
    scene.batches.push_back(turned.batches[0]);
    expectRight({scene, corner, pointLight({0.3, 5, 0.7})});
}

// Static casters are then looked up, and the animated one is counted in addition.
TEST(MaskAgainstRays, AnAnimatedBatchAmongStaticOnes) {
    Scene scene = yard().scene();
    Scene turned = SceneBuilder().box({-0.5f, 1.5f, -0.5f}, {0.5f, 2, 0.5f}).scene();
    turned.batches[0].worldFromBatch =
        glm::rotate(glm::translate(glm::dmat4(1.0), {1.5, 0.5, 0}), 0.7, {1.0, 2.0, 0.5});
    turned.batches[0].node = 0;
    scene.batches.push_back(turned.batches[0]);
    for (const Light& light : {pointLight({0.3, 5, 0.7}), sun({0.4, 1, -0.2})}) {
        const Case test{scene, corner, light};
        test::expectLookedUpRight(test);
        RenderSettings lookedUp;
        lookedUp.shadows = ShadowMethod::primitiveMap;
        EXPECT_GT(run(test, lookedUp).shadow, 500);
    }
}

} // namespace
} // namespace edgeshade
