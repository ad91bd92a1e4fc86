// Sums of exact masks: they must contain each point's own mask, drawn alone, exactly once.

#include "src/gl/framebuffer_keeper.hpp"
#include "src/render/accumulation/extended_lights.hpp"
#include "src/render/frame/prepare_scene.hpp"
#include "src/scene/shadow_facts.hpp"
#include "tests/support/bounded_frame.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/loaded_scene.hpp"
#include "tests/support/scene_builder.hpp"

#include <algorithm>
#include <GLES2/gl2.h>
#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::pointLight;
using test::SceneBuilder;
using test::sun;
using test::yard;

constexpr int width = 160, height = 120;
const Camera corner{{5, 4, 6}, {0, 0.5, 0}, 50.0};

/// A scene on the GPU, with its renderer.
struct Course {
    explicit Course(const Scene& scene, RenderSettings settings = {})
        : context(test::testPicture(width, height)) {
        if (!context.capabilities().instancing) settings.layout = SidesLayout::notInstanced;
        loaded = test::loadedOf(scene);
        gpu.emplace(uploadScene(loaded, settings.records(), context.capabilities()));
        renderer.emplace(settings, context.capabilities());
    }

    FrameView view(const Light& light, std::size_t points,
                   const Frustum& frustum = frustumOf(corner, 4.0 / 3.0)) const {
        FrameRequest request{
            .frustum = frustum, .width = width, .height = height, .lights = {light}};
        request.lightSamples = points;
        return test::boundedFrame(loaded.scene, false, request);
    }

    std::vector<std::uint8_t> draw(const FrameView& frame) {
        prepareScene(*gpu, loaded, frame, *renderer);
        renderer->draw(*gpu, frame);
        gl::requireNoError("drawing a test scene");
        return context.readPixels();
    }

    /// Lit points by pixel, with each point drawn alone as a hard light.
    std::vector<std::uint16_t> oneByOne(const Light& light, std::size_t points) {
        std::vector<std::uint16_t> sums(std::size_t{width} * height, 0);
        for (const Light& point : lightPoints(light, points)) {
            FrameView frame = view(point, 0);
            frame.mask = true;
            const std::vector<std::uint8_t> mask = draw(frame);
            for (std::size_t i = 0; i < sums.size(); ++i)
                sums[i] += mask[4 * i] != 0;
        }
        return sums;
    }

    LitCounts counted(const FrameView& frame, std::size_t atOnce) {
        prepareScene(*gpu, loaded, frame, *renderer);
        ExtendedLights lights(context.capabilities());
        while (lights.counted() < frame.lights.front().points.size())
            lights.advance(*renderer, *gpu, loaded, frame, atOnce);
        return lights.counts(0);
    }

    gl::HeadlessContext context;
    LoadedScene loaded;
    std::optional<GpuScene> gpu;
    std::optional<Renderer> renderer;
};

Light lamp(double radius) {
    Light light = pointLight({0.3, 4, 0.7});
    light.extent = {.shape = LightExtent::Shape::sphere, .radius = radius};
    return light;
}

Light panel() {
    Light light = pointLight({0.3, 3, 0.7});
    light.extent = {.shape = LightExtent::Shape::rectangle, .size = {2, 1}};
    return light;
}

Light wideSun() {
    Light light = sun({0.5, 1, -0.3});
    light.extent = {.shape = LightExtent::Shape::disc, .radius = 0.1};
    return light;
}

/// Expects equal bits except for `different` pixels, or with 16-bit depths for one in a thousand.
void expectSame(const std::vector<std::uint16_t>& counts, const std::vector<std::uint16_t>& others,
                std::size_t different = 0) {
    std::size_t found = 0;
    for (std::size_t i = 0; i < counts.size(); ++i)
        found += counts[i] != others[i];
    if (test::testLimits() != gl::Limits::device) different = counts.size() / 1000;
    EXPECT_LE(found, different);
}

TEST(ExtendedLights, EveryPointCountsOnceWhereverItAloneShines) {
    Course course(yard().scene());
    for (const Light& light : {lamp(0.4), panel(), wideSun()})
        expectSame(course.counted(course.view(light, 24), 24).lit, course.oneByOne(light, 24));
}

TEST(ExtendedLights, BitByBitIsTheSameAsAtOnce) {
    Course course(yard().scene());
    const FrameView frame = course.view(lamp(0.4), 30);
    const LitCounts whole = course.counted(frame, 30);
    EXPECT_EQ(whole.lights, 30u);
    for (const std::size_t atOnce : {std::size_t{1}, std::size_t{7}})
        EXPECT_EQ(course.counted(frame, atOnce).lit, whole.lit);
}

TEST(ExtendedLights, MoreThanAByteOfThemAreCounted) {
    Course course(SceneBuilder().floor(4).box({-1, 0.5f, -1}, {1, 1, 1}).scene());
    const LitCounts counts = course.counted(course.view(lamp(0.2), 700), 700);
    std::size_t all = 0, between = 0;
    for (const std::uint16_t lit : counts.lit) {
        EXPECT_LE(lit, 700u);
        all += lit == 700;
        between += lit > 255 && lit < 700;
    }
    EXPECT_GT(all, 1000u);
    EXPECT_GT(between, 50u);
}

TEST(ExtendedLights, CastersInGroupsAreCountedForEveryPoint) {
    // 300 sheets behind each other: more than a stencil counts.
    SceneBuilder builder = SceneBuilder().floor(4);
    for (int i = 0; i < 300; ++i) {
        const float y = 1.0f + 0.002f * static_cast<float>(i);
        builder.triangle({-0.8f, y, -0.8f}, {0.9f, y, -0.7f}, {0, y, 0.9f});
    }
    Course course(builder.scene());
    const FrameView frame = course.view(lamp(0.3), 3);
    ASSERT_GT(frame.lights.front().layers.groupCount, 1u);
    const std::vector<std::uint16_t> apart = course.oneByOne(lamp(0.3), 3);
    expectSame(course.counted(frame, 3).lit, apart, 3); // an edge in another group rounds
                                                        // differently
    EXPECT_LT(*std::min_element(apart.begin(), apart.end()), 3u);
}

TEST(ExtendedLights, AnOrthographicPictureCutsCastersForEveryPoint) {
    Course course(yard().scene());
    const Light light = lamp(0.4);
    const Frustum frustum = frustumOf(corner, 4.0 / 3.0, 6.0);
    const FrameView frame = course.view(light, 6, frustum);
    std::vector<std::uint16_t> sums(std::size_t{width} * height, 0);
    for (const Light& point : lightPoints(light, 6)) {
        FrameView one = course.view(point, 0, frustum);
        one.mask = true;
        const std::vector<std::uint8_t> mask = course.draw(one);
        for (std::size_t i = 0; i < sums.size(); ++i)
            sums[i] += mask[4 * i] != 0;
    }
    EXPECT_EQ(course.counted(frame, 6).lit, sums);
}

TEST(ExtendedLights, SurfacesAreWhereTheyAreSeen) {
    Course course(yard().scene());
    const LitCounts counts = course.counted(course.view(lamp(0.4), 20), 3);
    FrameView hard = course.view(lamp(0.4), 0);
    hard.mask = true;
    const std::vector<std::uint8_t> mask = course.draw(hard);
    for (std::size_t i = 0; i < counts.surface.size(); ++i)
        EXPECT_EQ(counts.surface[i], mask[4 * i + 3] != 0 ? counts.pictures : 0u);
}

/// The picture's red channel with the light's extent, and with only its centre.
struct Shaded {
    std::vector<std::uint8_t> soft, hard;
    LitCounts counts;
};

Shaded shaded(Course& course, const Light& light, std::size_t points) {
    const FrameView frame = course.view(light, points);
    prepareScene(*course.gpu, course.loaded, frame, *course.renderer);
    ExtendedLights lights(course.context.capabilities());
    drawWithExtents(*course.renderer, lights, *course.gpu, course.loaded, frame);
    Shaded result{course.context.readPixels(), {}, lights.counts(0)};
    result.hard = course.draw(course.view(light, 0));
    return result;
}

TEST(ExtendedLights, APictureIsLitByTheShareOfPointsThatIsSeen) {
    for (const Shading shading : {Shading::base, Shading::full}) {
        RenderSettings settings;
        settings.shading = shading;
        Course course(SceneBuilder().floor(4).box({-1, 0.5f, -1}, {1, 1, 1}).scene(), settings);
        const Shaded picture = shaded(course, wideSun(), 48);
        // The floor's brightness matches its share, from the darkest to the brightest.
        int least = 255, most = 0;
        for (std::size_t i = 0; i < picture.counts.lit.size(); ++i) {
            if (picture.counts.surface[i] == 0) continue;
            const int soft = picture.soft[4 * i], hard = picture.hard[4 * i];
            if (picture.counts.lit[i] == 48) {
                EXPECT_NEAR(soft, hard, 1);
            } else if (picture.counts.lit[i] > 0) {
                least = std::min(least, soft);
                most = std::max(most, soft);
            }
        }
        EXPECT_GT(most - least, 60);
    }
}

TEST(ExtendedLights, HalfOfThePointsIsHalfOfTheLight) {
    RenderSettings settings;
    settings.ambient = 0.2f;
    Course course(SceneBuilder().floor(4).box({-1, 0.5f, -1}, {1, 1, 1}).scene(), settings);
    const Shaded picture = shaded(course, wideSun(), 64);
    const double lambert = glm::normalize(glm::dvec3(0.5, 1, -0.3)).y;
    std::size_t checked = 0;
    for (std::size_t i = 0; i < picture.counts.lit.size(); ++i) {
        const std::uint16_t lit = picture.counts.lit[i];
        if (picture.counts.surface[i] == 0 || lit == 0 || lit == 64) continue;
        const double share = 0.2 + 0.8 * lambert * lit / 64.0;
        const bool isFloor = std::abs(picture.soft[4 * i] - 255.0 * share) <= 1.5;
        checked += isFloor;
    }
    EXPECT_GT(checked, 80u);
}

TEST(ExtendedLights, ShadingByPointsAddsUpToTheWholeLight) {
    RenderSettings settings;
    settings.shading = Shading::full;
    Course course(SceneBuilder().floor(4).box({-1, 0.5f, -1}, {1, 1, 1}).scene(), settings);
    if (!LinearTarget::isPossible(course.context.capabilities())) GTEST_SKIP() << "no half floats";
    const Shaded picture = shaded(course, wideSun(), 32);
    const std::vector<std::uint8_t> byPoints =
        course.draw(shadedByPoints(course.view(wideSun(), 32)));
    std::size_t compared = 0;
    for (std::size_t i = 0; i < picture.counts.lit.size(); ++i) {
        if (picture.counts.surface[i] == 0) continue;
        // The sun's disc is small: each point's own Lambert term nearly equals the centre's.
        EXPECT_NEAR(byPoints[4 * i], picture.soft[4 * i], 6);
        ++compared;
    }
    EXPECT_GT(compared, 5000u);
}

TEST(ExtendedLights, AnExtentThatNobodyCountedIsAHardLight) {
    Course course(yard().scene());
    Light point = lamp(0.4);
    const std::vector<std::uint8_t> extended = course.draw(course.view(point, 16));
    point.extent.reset();
    EXPECT_EQ(course.draw(course.view(point, 0)), extended);
}

TEST(PictureSum, AddsBytesExactlyPastTheirRange) {
    const gl::HeadlessContext context(test::testPicture(8, 8));
    gl::ColorTarget picture(8, 8);
    PictureSum sum;
    sum.begin(8, 8);
    std::array<std::uint32_t, 4> expected{};
    for (int i = 0; i < 300; ++i) {
        const std::array<int, 3> color = {i % 256, 255, (7 * i) % 256};
        const bool some = i % 3 == 0;
        glBindFramebuffer(GL_FRAMEBUFFER, picture.framebuffer.name());
        glClearColor(static_cast<float>(color[0]) / 255.0f, static_cast<float>(color[1]) / 255.0f,
                     static_cast<float>(color[2]) / 255.0f, some ? 1.0f : 0.0f);
        glClear(GL_COLOR_BUFFER_BIT);
        if (i == 200) { // the first pictures are dropped
            sum.begin(8, 8);
            expected = {};
        }
        sum.add(picture.texture.name());
        for (std::size_t c = 0; c < 3; ++c)
            expected[c] += static_cast<std::uint32_t>(color[c]);
        expected[3] += some;
    }
    gl::requireNoError("adding up");
    const std::vector<std::uint16_t> sums = sum.read();
    for (std::size_t i = 0; i < sums.size(); ++i)
        ASSERT_EQ(sums[i], expected[i % 4]);
}

TEST(PictureSum, ShowsTheMean) {
    const gl::HeadlessContext context(test::testPicture(8, 8));
    GLint shown = 0;
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &shown);
    gl::ColorTarget picture(8, 8);
    PictureSum sum;
    sum.begin(8, 8);
    for (const float red : {0.0f, 1.0f, 1.0f, 1.0f}) {
        glBindFramebuffer(GL_FRAMEBUFFER, picture.framebuffer.name());
        glClearColor(red, 0.2f, 1.0f, 1.0f);
        glClear(GL_COLOR_BUFFER_BIT);
        sum.add(picture.texture.name());
    }
    sum.show(static_cast<gl::Name>(shown), 4 * 255);
    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(shown));
    const std::vector<std::uint8_t> pixels = context.readPixels();
    EXPECT_NEAR(pixels[0], 191, 1);
    EXPECT_NEAR(pixels[1], 51, 1);
    EXPECT_EQ(pixels[2], 255);
    EXPECT_EQ(pixels[3], 255);
}

TEST(ExtendedLights, ThatAreLookedUpNeedNoBoundOfLayers) {
    RenderSettings settings;
    settings.shadows = ShadowMethod::primitiveMap;
    Course course(yard().scene(), settings);
    const gl::Capabilities& capabilities = course.context.capabilities();
    if (!deviceFactsOf(capabilities).floatTables) GTEST_SKIP() << "needs float textures";
    Light lamp = pointLight({0.3, 4, 0.7});
    lamp.extent = {.shape = LightExtent::Shape::sphere, .radius = 0.5};
    FrameView view = course.view(lamp, 8);
    const auto boundsWith = [&](bool pointsAreLights) {
        view.lights.front().layers = {};
        boundCountedLayers(view, course.loaded, *course.gpu,
                           course.renderer->policyFor(sceneFactsOf(*course.gpu)), pointsAreLights);
        return view.lights.front().layers.most;
    };
    EXPECT_GT(boundsWith(false), 0u); // counted until there is a map
    makeLookups(*course.gpu, course.loaded, view, *course.renderer);
    ASSERT_NE(extendedMapOf(*course.gpu, lamp), nullptr);
    EXPECT_EQ(boundsWith(false), 0u);
    EXPECT_GT(boundsWith(true), 0u);
}

} // namespace
} // namespace edgeshade
