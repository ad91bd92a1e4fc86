// Volumes counted at a lower resolution (--mask-scale): the same answer as ray casting away from
// the boundaries of shadows, and no leaks over the outline of a surface.

#include "preprocess/base/error.hpp"
#include "src/gl/headless_context.hpp"
#include "tests/support/bounded_frame.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/scene_builder.hpp"

#include <cstdlib>
#include <GLES2/gl2.h>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::Answer;
using test::pointLight;
using test::SceneBuilder;
using test::sun;
using test::TestView;

constexpr int width = 251, height = 189; // not multiples of 2

RenderSettings coarse(int scale) {
    RenderSettings settings;
    settings.maskScale = scale;
    return settings;
}

std::size_t at(int x, int y) {
    return static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
}

/// Whether all pixels within `reach` have the same value as the pixel.
template <class Value>
bool isFlat(const std::vector<Value>& values, int x, int y, int reach) {
    for (int ny = std::max(0, y - reach); ny <= std::min(height - 1, y + reach); ++ny)
        for (int nx = std::max(0, x - reach); nx <= std::min(width - 1, x + reach); ++nx)
            if (!(values[at(nx, ny)] == values[at(x, y)])) return false;
    return true;
}

struct Wrong {
    int all = 0;
    int awayFromBoundaries = 0; ///< more than a texel and a half from boundaries of shadows and
                                ///< surfaces
    int lit = 0, shadow = 0;
};

Wrong wrongIn(const Scene& scene, const Frustum& frustum, const Light& light, int scale) {
    TestView view{{}, {light}, width, height, true};
    view.frustum = frustum;
    const auto mask = test::drawScene(scene, view, coarse(scale));
    const auto answers =
        test::castMask(scene, standingBack(frustum, worldBounds(scene)), light, width, height, 0.0);
    Wrong wrong;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Answer answer = answers[at(x, y)];
            const std::uint8_t* pixel = &mask[4 * at(x, y)];
            const Answer drawn = pixel[3] == 0   ? Answer::nothing
                                 : pixel[0] == 0 ? Answer::shadow
                                                 : Answer::lit;
            wrong.lit += answer == Answer::lit;
            wrong.shadow += answer == Answer::shadow;
            if (drawn == answer) continue;
            ++wrong.all;
            wrong.awayFromBoundaries += isFlat(answers, x, y, scale + scale / 2 + 1);
        }
    return wrong;
}

Wrong wrongIn(const Scene& scene, const Camera& camera, const Light& light, int scale) {
    return wrongIn(scene, frustumOf(camera, static_cast<double>(width) / height), light, scale);
}

const Light lights[] = {pointLight({1.7, 4, 0.7}), pointLight({-6, 3.5, 4}), sun({0.5, 1, -0.3})};
const Camera corner{{5, 4, 6}, {0, 0.5, 0}, 50.0};

TEST(CoarseMask, IsRightAwayFromBoundaries) {
    for (const Light& light : lights)
        for (const int scale : {2, 4}) {
            const Wrong wrong = wrongIn(test::yard().scene(), corner, light, scale);
            EXPECT_EQ(wrong.awayFromBoundaries, 0) << "scale " << scale;
            // About as many as lie along boundaries.
            EXPECT_LE(wrong.all, scale * width * height / 300) << "scale " << scale;
            EXPECT_GT(wrong.lit, 1000);
            EXPECT_GT(wrong.shadow, 1000);
        }
}

TEST(CoarseMask, IsRightInAnyProjection) {
    const glm::dmat4 view = viewFromWorld(corner);
    const double aspect = static_cast<double>(width) / height;
    const Frustum offAxis =
        frustumOf(view, glm::frustum(-0.02 * aspect, 0.06 * aspect, -0.05, 0.03, 0.1, 10.0));
    for (const Frustum& frustum : {offAxis, frustumOf(corner, aspect, 7.0)})
        for (const Light& light : lights)
            for (const int scale : {2, 4}) {
                const Wrong wrong = wrongIn(test::yard().scene(), frustum, light, scale);
                EXPECT_EQ(wrong.awayFromBoundaries, 0) << "scale " << scale;
                EXPECT_LE(wrong.all, scale * width * height / 200) << "scale " << scale;
                EXPECT_GT(wrong.shadow, 1000);
            }
}

// A card over a floor, seen from above; a wall beside the view keeps the low sun from one of them.
// The only boundary in view is the card's outline, so that every pixel must be right.
//
//    sun ->      |wall     ____ card
//                |
//                          ____________ floor
void expectCleanOutline(float wallLow, float wallHigh) {
    const Scene scene = SceneBuilder()
                            .floor(20)
                            .quad({-1, 3, 1.3f}, {1.2f, 3, 1}, {1, 3, -1}, {-1.1f, 3, -1})
                            .box({6, wallLow, -30}, {6.1f, wallHigh, 30})
                            .scene();
    const Camera above{{0, 12, 0}, {0, 0, 0}, 24.0};
    for (const int scale : {1, 2, 4}) {
        const Wrong wrong = wrongIn(scene, above, sun({1, 0.3, 0}), scale);
        EXPECT_EQ(wrong.all, 0) << "scale " << scale;
        EXPECT_GT(wrong.lit, 1000);
        EXPECT_GT(wrong.shadow, 1000);
    }
}

TEST(CoarseMask, LightDoesNotLeakOverOutlines) {
    expectCleanOutline(0.0f, 3.0f); // the floor is dark
}

TEST(CoarseMask, ShadowDoesNotLeakOverOutlines) {
    expectCleanOutline(3.2f, 10.0f); // the card is dark
}

// A lit wall stands on a floor that a beam behind the camera keeps dark: no light may leak from the
// wall onto the floor where they meet, nor shadow up the wall.
TEST(CoarseMask, CornersStayClean) {
    const Scene scene = SceneBuilder()
                            .floor(20)
                            .quad({-3, 0.001f, 0}, {3, 0.001f, 0}, {3, 4, 0}, {-3, 4, 0})
                            .box({-30, 4, 7}, {30, 7.0005f, 7.1f})
                            .scene();
    // The shadow of the beam's top falls on the corner itself; that of its foot ends before the
    // view.
    const Camera camera{{0.3, 3, 5.5}, {0.2, 0.3, 0}, 24.0};
    for (const int scale : {1, 2, 4}) {
        const Wrong wrong = wrongIn(scene, camera, sun({0.1, 1, 1}), scale);
        // Along the corner, at most the ends have no texel of their own surface.
        EXPECT_LE(wrong.all, scale == 1 ? 0 : 8) << "scale " << scale;
        EXPECT_GT(wrong.lit, 1000);
        EXPECT_GT(wrong.shadow, 1000);
    }
}

/// Holes, glass, a mirrored placement, depths from 0.3 to 60, and 300 sheets above each other, more
/// than an 8-bit stencil can count.
Scene everything() {
    Material cutOut, glass;
    cutOut.alphaMode = AlphaMode::mask;
    glass.alphaMode = AlphaMode::blend;
    glass.baseColorFactor = {0.2f, 0.5f, 1.0f, 0.4f};
    SceneBuilder builder;
    builder.floor(60).box({-2, 0, -2}, {-1, 2.5f, -1}).box({8, 0, -30}, {12, 9, -26});
    for (int i = 0; i < 300; ++i) {
        const float y = 1.0f + 0.002f * static_cast<float>(i);
        builder.quad({0.5f, y, 1}, {2, y, 1}, {2, y, -1}, {0.5f, y, -1});
    }
    builder.material(cutOut).quad({-1, 1.5f, 1}, {0, 1.5f, 1}, {0, 1.7f, 0}, {-1, 1.7f, 0});
    builder.material(glass).quad({-3, 0.3f, 2}, {3, 0.3f, 2}, {3, 1.1f, 2}, {-3, 1.1f, 2});
    return builder.placedBy(glm::dmat4(-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1)).scene();
}

TEST(CoarseMask, GoesWithEverythingElse) {
    TestView view{{{0.4, 2.2, 6.5}, {0, 0.7, 0}, 55.0},
                  {pointLight({3, 6, 2}), sun({-0.5, 1, 0.4}), pointLight({-2, 5, 3})},
                  width,
                  height};
    view.depth.slices = 2;
    for (const auto& [mask, castMasked] : {std::pair(false, false), {false, true}, {true, false}}) {
        view.mask = mask;
        RenderSettings settings;
        settings.layout = castMasked ? SidesLayout::notInstanced : SidesLayout::instanced;
        const auto exact = test::drawScene(everything(), view, settings, castMasked);
        std::vector<std::array<int, 4>> colors;
        for (std::size_t i = 0; i < exact.size(); i += 4)
            colors.push_back({exact[i], exact[i + 1], exact[i + 2], exact[i + 3]});
        for (const int scale : {2, 4}) {
            settings.maskScale = scale;
            const auto drawn = test::drawScene(everything(), view, settings, castMasked);
            int differ = 0, away = 0;
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x) {
                    bool same = true, edge = false;
                    for (std::size_t c = 0; c < 4; ++c)
                        same = same &&
                               std::abs(drawn[4 * at(x, y) + c] - exact[4 * at(x, y) + c]) <= 2;
                    if (same) continue;
                    ++differ;
                    // Shading changes slowly except at boundaries.
                    for (int ny = y - 2 * scale; ny <= y + 2 * scale; ++ny)
                        for (int nx = x - 2 * scale; nx <= x + 2 * scale; ++nx)
                            if (nx >= 0 && ny >= 0 && nx < width && ny < height)
                                for (std::size_t c = 0; c < 4; ++c)
                                    edge = edge || std::abs(colors[at(nx, ny)][c] -
                                                            colors[at(x, y)][c]) > 8;
                    away += !edge;
                }
            EXPECT_EQ(away, 0) << "mask " << mask << ", scale " << scale;
            EXPECT_GT(differ, 0) << "nothing was coarse";
            EXPECT_LT(differ, width * height / 20) << "mask " << mask << ", scale " << scale;
        }
    }
}

TEST(CoarseMask, PictureAndMaskAgree) {
    // A white floor under a directional light from above: 255 where lit, 0 elsewhere.
    const Scene scene =
        SceneBuilder().floor(9).quad({-1, 2, 2}, {2, 2, 1}, {1, 2, -2}, {-2, 2, -1}).scene();
    TestView view{{{0, 5, 0}, {1, 0, 0.5}, 70.0}, {sun({0.3, 1, 0.2})}, width, height};
    RenderSettings settings = coarse(4);
    settings.ambient = 0.0f;
    const auto picture = test::drawScene(scene, view, settings);
    view.mask = true;
    const auto mask = test::drawScene(scene, view, settings);
    for (std::size_t i = 0; i < mask.size(); i += 4) {
        if (mask[i + 3] == 0) continue;
        ASSERT_TRUE(mask[i] == 0 ? picture[i] == 0 : picture[i] > 200) << "pixel " << i / 4;
    }
}

/// The yard on a GPU, drawn into the bound framebuffer.
struct Yard {
    explicit Yard(const gl::Capabilities& capabilities, int scale) {
        const Scene scene = test::yard().scene();
        loaded = {{}, scene, {}, buildPlanePairs(scene, false), {}, {}};
        view = test::boundedFrame(loaded.scene, loaded.settings.castMasked,
                                  {frustumOf(corner, static_cast<double>(width) / height),
                                   width,
                                   height,
                                   {lights[1]},
                                   {}});
        RenderSettings settings = coarse(scale);
        settings.layout = bestLayout(capabilities);
        renderer.emplace(settings, capabilities);
        gpu = uploadScene(loaded, settings.records(), capabilities);
    }
    void draw() {
        renderer->draw(*gpu, view);
        gl::requireNoError("drawing a test scene");
    }

    LoadedScene loaded;
    FrameView view;
    std::optional<Renderer> renderer;
    std::optional<GpuScene> gpu;
};

int pixelsUnlike(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    int count = 0;
    for (std::size_t i = 0; i < a.size(); i += 4)
        count += std::abs(a[i] - b[i]) > 2 || std::abs(a[i + 1] - b[i + 1]) > 2;
    return count;
}

TEST(CoarseMask, DrawsIntoTheFramebufferThatIsBound) {
    std::vector<std::uint8_t> plain;
    {
        const gl::HeadlessContext context({width, height});
        Yard yard(context.capabilities(), 2);
        yard.draw();
        plain = context.readPixels();
        EXPECT_GE(yard.renderer->maskBytes(), std::size_t{126} * 95 * 11);
    }
    std::optional<gl::HeadlessContext> sampled;
    try {
        sampled.emplace(gl::HeadlessContext::Request{width, height, 4});
    } catch (const Error& error) {
        GTEST_SKIP() << error.what();
    }
    Yard yard(sampled->capabilities(), 2);
    GLint before = 0, after = 0;
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &before);
    yard.draw();
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &after);
    EXPECT_EQ(before, after);
    EXPECT_NE(before, 0);
    // Samples only change outlines.
    EXPECT_LT(pixelsUnlike(plain, sampled->readPixels()), width * height / 15);
}

TEST(CoarseMask, KeepsTheScissor) {
    const gl::HeadlessContext context({width, height});
    Yard yard(context.capabilities(), 2);
    yard.draw();
    const auto whole = context.readPixels();
    glClearColor(1, 0, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glEnable(GL_SCISSOR_TEST);
    glScissor(60, 40, 101, 80);
    yard.draw();
    EXPECT_EQ(glIsEnabled(GL_SCISSOR_TEST), GL_TRUE);
    const auto part = context.readPixels();
    int wrong = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const int row = height - 1 - y; // GL's
            const bool inside = x >= 60 && x < 161 && row >= 40 && row < 120;
            const std::uint8_t* pixel = &part[4 * at(x, y)];
            const bool cleared = pixel[0] == 255 && pixel[1] == 0 && pixel[2] == 255;
            wrong += inside ? pixel[0] != whole[4 * at(x, y)] : !cleared;
        }
    EXPECT_EQ(wrong, 0);
}

TEST(CoarseMask, NeedsDerivatives) {
    const gl::HeadlessContext context({width, height});
    gl::Capabilities without = context.capabilities();
    const std::string name = "GL_OES_standard_derivatives";
    ASSERT_NE(without.extensions.find(name), std::string::npos);
    without.extensions.replace(without.extensions.find(name), name.size(), "GL_none");
    RenderSettings settings = coarse(2);
    settings.layout = bestLayout(without);
    try {
        const Renderer renderer(settings, without);
        FAIL() << "derivatives weren't missed";
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), ExitStatus::unavailable);
        EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
    }
    settings.maskScale = 1;
    const Renderer exact(settings, without);
}

TEST(CoarseMask, DrawsOrRefusesWithoutPackedDepthAndStencil) {
    const gl::HeadlessContext context({width, height});
    Yard packed(context.capabilities(), 2);
    packed.draw();
    const auto expected = context.readPixels();
    gl::Capabilities without = context.capabilities();
    without.version = "OpenGL ES 2.0";
    const std::string name = "GL_OES_packed_depth_stencil";
    ASSERT_NE(without.extensions.find(name), std::string::npos);
    without.extensions.replace(without.extensions.find(name), name.size(), "GL_none");
    Yard apart(without, 2);
    try {
        apart.draw();
        EXPECT_EQ(pixelsUnlike(expected, context.readPixels()), 0);
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), ExitStatus::unavailable);
        EXPECT_NE(std::string(error.what()).find("stencil"), std::string::npos) << error.what();
    }
}

} // namespace
} // namespace edgeshade
