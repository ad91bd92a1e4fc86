// Lights with a range (--light-range): what they light, and which casters are left out as out of
// reach.

#include "src/gl/headless_context.hpp"
#include "src/rivals/rivals.hpp"
#include "src/shadow/view/light_reach.hpp"
#include "tests/support/bounded_frame.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/hard_lights.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/pixel_place.hpp"
#include "tests/support/scene_builder.hpp"

#include <cstdlib>
#include <GLES2/gl2.h>
#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::Answer;
using test::Random;
using test::SceneBuilder;
using test::sun;
using test::TestView;

constexpr int width = 240, height = 180;

Light lamp(const glm::dvec3& position, double range) {
    return {glm::dvec4(position, 1.0), range};
}

FrameView viewFrom(const Camera& camera, double near, double farthest) {
    FrameView view;
    view.frustum = frustumOf(camera, static_cast<double>(width) / height);
    view.width = width;
    view.height = height;
    view.slices = {{near, std::numeric_limits<double>::infinity()}};
    view.farthestDepth = farthest;
    return view;
}

TEST(LightReach, HoldsEveryVisiblePointOfTheBall) {
    Random random(5);
    int inside = 0, crossing = 0, checked = 0, small = 0;
    for (int i = 0; i < 8000; ++i) {
        const Camera camera{3.0 * random.inCube(), 3.0 * random.inCube(), random.uniform(5, 150)};
        const double near = random.magnitude(-3, 0), farthest = near * random.magnitude(0.5, 3);
        const FrameView view = viewFrom(camera, near, farthest);
        const Light light =
            lamp(camera.from + random.inCube() * random.magnitude(-2, 1), random.magnitude(-3, 1));
        const PixelRectangle reach = lightReach(view, view.slices[0], light);
        const glm::dvec3 center(light.position);
        const double depth = -(viewFromWorld(camera) * light.position).z;
        inside += glm::distance(center, camera.from) < light.range;
        crossing += std::abs(depth - near) < light.range;
        small += !reach.empty() && reach.width * reach.height < width * height / 4;
        const glm::dmat4 clipFromWorld =
            clipFromView(view.frustum, near) * view.frustum.viewFromWorld;
        for (int p = 0; p < 60; ++p) {
            // On the ball or inside.
            const glm::dvec3 direction = glm::normalize(random.inCube());
            const double share = p % 3 == 0 ? random.uniform(0, 1) : 1.0;
            const glm::dvec3 point = center + light.range * share * direction;
            const glm::dvec4 clip = clipFromWorld * glm::dvec4(point, 1.0);
            if (clip.w < near || clip.w > farthest) continue;
            const auto place = test::placeInPicture(clip, view);
            if (!place) continue;
            ++checked;
            ASSERT_TRUE(test::holds(reach, *place))
                << "ball " << i << ": " << place->x << ", " << place->y;
        }
    }
    EXPECT_GT(inside, 300);
    EXPECT_GT(crossing, 300);
    EXPECT_GT(checked, 20'000);
    EXPECT_GT(small, 300) << "the whole picture is right, but no help";
}

TEST(LightReach, IsTightAroundASmallBall) {
    const FrameView view = viewFrom({{0, 0, 0}, {0, 0, -1}, 90.0}, 0.1, 100.0);
    // At depth 10 the picture is 20 high: the ball's outline is just over 18 pixels.
    const PixelRectangle reach = lightReach(view, view.slices[0], lamp({0, 5, -10}, 1.0));
    EXPECT_NEAR(reach.width, 18, 4);
    EXPECT_NEAR(reach.height, 20, 5);
    EXPECT_NEAR(reach.x + reach.width / 2, width / 2, 2);
    EXPECT_NEAR(reach.y + reach.height / 2, 135, 4);
}

TEST(LightReach, IsEmptyWhereTheBallMissesTheView) {
    FrameView view = viewFrom({{0, 0, 0}, {0, 0, -1}, 60.0}, 0.1, 100.0);
    const auto reaches = [&](const Light& light) {
        return !lightReach(view, view.slices[0], light).empty();
    };
    EXPECT_FALSE(reaches(lamp({0, 0, 3}, 2.0)));     // behind the eye
    EXPECT_TRUE(reaches(lamp({0, 0, 3}, 4.0)));      // the eye is inside
    EXPECT_FALSE(reaches(lamp({20, 0, -10}, 5.0)));  // to the right
    EXPECT_FALSE(reaches(lamp({0, -20, -10}, 5.0))); // below
    EXPECT_FALSE(reaches(lamp({0, 0, -110}, 9.0)));  // beyond all visible geometry
    EXPECT_TRUE(reaches(lamp({0, 0, -110}, 12.0)));
    EXPECT_TRUE(reaches({{20, 0, -10, 1}}));     // without a range
    EXPECT_TRUE(reaches({{0, 0, 1, 0}, 0.001})); // a directional light has no range
    view.slices[0] = {0.1, 5.0};
    EXPECT_FALSE(reaches(lamp({0, 0, -10}, 4.0))); // in a farther slice
}

TEST(LightReach, ARangeInAnObjectIsNoLess) {
    Random random(9);
    for (int i = 0; i < 2000; ++i) {
        glm::dmat4 worldFromObject(1.0);
        for (glm::length_t column = 0; column < 3; ++column)
            worldFromObject[column] = glm::dvec4(random.inCube() * random.magnitude(-1, 1), 0.0);
        if (std::abs(glm::determinant(worldFromObject)) < 1e-3) continue;
        const glm::dvec3 point = random.inCube();
        const double inWorld = glm::length(glm::dmat3(worldFromObject) * point);
        ASSERT_GE(rangeInObject(inWorld, worldFromObject), glm::length(point) * (1.0 - 1e-9));
    }
    const glm::dmat4 scaled(2, 0, 0, 0, 0, 0, -2, 0, 0, 2, 0, 0, 5, 6, 7, 1);
    EXPECT_NEAR(rangeInObject(3.0, scaled), 1.5, 1e-12);
}

TEST(LightReach, ScaledHoldsTheSamePixels) {
    const FrameView view = viewFrom({}, 0.1, 10.0);
    const glm::ivec2 size(61, 45);
    const PixelRectangle part = scaledReach({100, 50, 21, 11}, view, size);
    EXPECT_LE(part.x, 24);
    EXPECT_GE(part.x + part.width, 32);
    EXPECT_LE(part.y, 12);
    EXPECT_GE(part.y + part.height, 16);
    const PixelRectangle whole = scaledReach({0, 0, width, height}, view, size);
    EXPECT_EQ(whole.width, 61);
    EXPECT_EQ(whole.height, 45);
}

/// Expects the same lit mask as from ray casting.
void expectRight(const Camera& camera, const Light& light, RenderSettings settings,
                 double tolerated = 0.0, std::optional<int> slices = {}) {
    const Scene scene = test::yard().scene();
    TestView view{camera, {light}, width, height, true};
    view.depth.slices = slices;
    const auto mask = test::drawScene(scene, view, settings);
    const auto answers = test::castMask(scene, camera, light, width, height, 0.0);
    int wrong = 0, lit = 0, shadow = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::size_t i = static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
            lit += answers[i] == Answer::lit;
            shadow += answers[i] == Answer::shadow;
            const Answer drawn = mask[4 * i + 3] == 0 ? Answer::nothing
                                 : mask[4 * i] == 0   ? Answer::shadow
                                                      : Answer::lit;
            wrong += drawn != answers[i] && test::isFlat(answers, width, height, x, y);
        }
    EXPECT_LE(wrong, tolerated * width * height);
    EXPECT_GT(lit, 200);
    EXPECT_GT(shadow, 200);
}

const Camera outside{{5, 4, 6}, {0, 0.5, 0}, 50.0};
const Camera within{{0.2, 1.4, 2.6}, {-0.6, 0.6, 0}, 80.0};

TEST(LightRange, MasksAreThoseOfRays) {
    for (const Camera& camera : {outside, within})
        for (const Light& light : {lamp({0.2, 2.5, 1.2}, 3.3), lamp({-3, 1.5, 2.5}, 4.5)})
            for (const auto method :
                 {MultiplicityMethod::plane, MultiplicityMethod::referenceEdge}) {
                RenderSettings settings;
                settings.multiplicity = method;
                expectRight(camera, light, settings);
                expectRight(camera, light, settings, 0.0, 3);
            }
}

TEST(LightRange, PrimitiveMapsAreThoseOfRays) {
    RenderSettings settings;
    settings.shadows = ShadowMethod::primitiveMap;
    for (const Camera& camera : {outside, within})
        for (const Light& light :
             {lamp({0.2, 2.5, 1.2}, 3.3), lamp({-3, 1.5, 2.5}, 4.5), lamp({0.2, 1.3, 1.2}, 1.6),
              lamp({-6.5, 1.5, 1}, 3.5), lamp({-6.5, 1.5, 1}, 7.5), lamp({0, 9, 0.5}, 9.5)}) {
            settings.primitiveMap.size = 512;
            expectRight(camera, light, settings);
            settings.primitiveMap.size = 8; // texels that reach far beyond the range
            expectRight(camera, light, settings);
        }
}

TEST(LightRange, CoarseMasksAreThoseOfRaysAsFarAsTheyGo) {
    if (!test::hasDerivatives()) GTEST_SKIP() << "without derivatives there is no coarse mask";
    RenderSettings settings;
    settings.maskScale = 2;
    for (const Camera& camera : {outside, within})
        expectRight(camera, lamp({0.2, 2.5, 1.2}, 3.3), settings, 0.005, 2);
}

TEST(LightRange, MapsAreNearlyThoseOfRays) {
    RenderSettings settings;
    settings.shadows = ShadowMethod::map;
    for (const Camera& camera : {outside, within})
        for (const Light& light : {lamp({0.2, 2.5, 1.2}, 3.3), lamp({-6.5, 1.5, 1}, 3.5)})
            expectRight(camera, light, settings, 0.01);
}

TEST(LightRange, AMapOfALightThatReachesNothingIsEmpty) {
    RenderSettings settings;
    settings.shadows = ShadowMethod::map;
    const TestView view{outside, {lamp({0, 9, 0}, 1.0)}, width, height, true};
    const auto mask = test::drawScene(test::yard().scene(), view, settings);
    for (std::size_t i = 0; i < mask.size(); i += 4)
        ASSERT_EQ(mask[i], 0);
}

// A white floor under a point light at height 3: 255 * (0.2 + 0.8 * (1 - (3 / range)^4)) in the
// middle.
TEST(LightRange, TheWindowWeighsLambertsLaw) {
    const Scene scene = SceneBuilder().floor(8).scene();
    const auto middle = [&](const Light& light) {
        RenderSettings settings;
        settings.ambient = 0.2f;
        const auto pixels =
            test::drawScene(scene, {{{0, 10, 0}, {0, 0, 0}, 45.0}, {light}, 64, 64}, settings);
        return static_cast<int>(pixels[4 * (32 * 64 + 32)]);
    };
    for (const double range : {3.1, 4.0, 6.0, 30.0})
        EXPECT_NEAR(middle(lamp({0, 3, 0}, range)),
                    255.0 * (0.2 + 0.8 * (1.0 - std::pow(3.0 / range, 4))), 2.0)
            << range;
    EXPECT_EQ(middle(lamp({0, 3, 0}, 2.9)), 51);
    EXPECT_EQ(middle({{0, 3, 0, 1}}), 255);
    EXPECT_EQ(middle({{0, 1, 0, 0}, 2.9}), 255) << "a directional light has no range";
}

/// Draws many boxes in rows and returns the number of vertices of their volumes.
std::size_t runsWith(const Light& light, int maskScale = 1,
                     MultiplicityMethod method = MultiplicityMethod::plane) {
    SceneBuilder builder;
    builder.floor(60);
    for (int x = -25; x <= 25; ++x)
        for (int z = -25; z <= 25; ++z)
            builder.box({2.0 * x, 0.2f, 2.0 * z}, {2.0 * x + 1.0, 1, 2.0 * z + 1.0});
    const gl::HeadlessContext context(test::testPicture(width, height));
    RenderSettings settings;
    settings.rivals = &allRivals();
    settings.maskScale = maskScale;
    settings.multiplicity = method;
    settings.layout = bestLayout(context.capabilities());
    const LoadedScene loaded{{}, builder.scene(), {}, buildPlanePairs(builder.scene(), false), {},
                             {}};
    const FrameView view = test::boundedFrame(
        loaded.scene, loaded.settings.castMasked,
        {frustumOf({{0, 6, 14}, {0, 0, 0}, 60.0}, static_cast<double>(width) / height),
         width,
         height,
         {light},
         {}});
    GpuScene gpu = uploadScene(loaded, settings.records(), context.capabilities());
    Renderer renderer(settings, context.capabilities());
    glScissor(1, 2, 3, 4);
    renderer.draw(gpu, view);
    GLint box[4] = {};
    glGetIntegerv(GL_SCISSOR_BOX, box);
    EXPECT_EQ(glIsEnabled(GL_SCISSOR_TEST), GL_FALSE);
    EXPECT_TRUE(box[0] == 1 && box[1] == 2 && box[2] == 3 && box[3] == 4);
    return renderer.vertexRuns();
}

TEST(LightRange, WhatIsOutOfItCostsNothing) {
    const std::size_t all = runsWith({{0, 3, 0, 1}});
    const std::size_t near = runsWith(lamp({0, 3, 0}, 6.0));
    EXPECT_GT(near, 0u);
    EXPECT_LT(near, all / 3);
    for (const int scale : {1, 2})
        if (scale == 1 || test::hasDerivatives()) {
            EXPECT_EQ(runsWith(lamp({0, 3, 40}, 6.0), scale), 0u); // behind the eye
        }
    EXPECT_EQ(runsWith(lamp({0, 3, 40}, 6.0), 1, MultiplicityMethod::referenceEdge), 0u);
}

TEST(LightRange, GoesWithGroupsOfCasters) {
    // More sheets than a stencil can count: within the range the mask is the same as without a
    // range.
    SceneBuilder builder;
    builder.floor(9);
    for (int i = 0; i < 300; ++i) {
        const float y = 1.0f + 0.002f * static_cast<float>(i);
        builder.quad({-1, y, 1}, {1, y, 1}, {1, y, -1}, {-1, y, -1});
    }
    const auto maskOf = [&](const Light& light, ShadowMethod shadows, int scale) {
        RenderSettings settings;
        settings.shadows = shadows;
        settings.maskScale = scale;
        return test::drawScene(builder.scene(),
                               {{{3, 6, 5}, {0, 0, 0}, 60.0}, {light}, width, height, true},
                               settings);
    };
    const Light light = lamp({0.4, 4, 0.3}, 5.0);
    for (const int scale : {1, 2}) {
        if (scale > 1 && !test::hasDerivatives()) continue;
        const auto drawn = maskOf(light, ShadowMethod::volumes, scale);
        const auto reached = maskOf(light, ShadowMethod::none, 1);
        const auto endless = maskOf({light.position}, ShadowMethod::volumes, scale);
        int lit = 0;
        for (std::size_t i = 0; i < drawn.size(); i += 4) {
            const bool expected = reached[i] != 0 && endless[i] != 0;
            lit += expected;
            ASSERT_EQ(drawn[i] != 0, expected) << "pixel " << i / 4 << ", scale " << scale;
            ASSERT_EQ(drawn[i + 3], endless[i + 3]);
        }
        EXPECT_GT(lit, 1000);
    }
}

} // namespace
} // namespace edgeshade
