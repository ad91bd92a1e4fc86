// The debug picture: colours at the sides and caps of a known caster, from the frame's own plan,
// and nowhere else.
#include "src/render/frame/frame.hpp"
#include "src/render/frame/volume_tint_pass.hpp"
#include "src/rivals/rivals.hpp"
#include "tests/support/bounded_frame.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/scene_builder.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::pointLight;
using test::SceneBuilder;
using Picture = std::vector<std::uint8_t>;

constexpr int width = 160, height = 120;

/// Pictures of one frame, with and without the tint.
struct Pictures {
    Picture plain, tinted, mask;
};

using Change = std::function<void(FramePlan&)>;

/// Draws the scene, and tints it by the frame's plan, changed by `change`.
Pictures pictures(const Scene& scene, const FrameRequest& request, bool castMasked = false,
                  RenderSettings settings = {}, const Change& change = {}) {
    const gl::HeadlessContext context(test::testPicture(request.width, request.height));
    settings.layout = bestLayout(context.capabilities());
    const LoadedScene loaded{
        {}, scene, {}, buildPlanePairs(scene, castMasked), {}, {0.0, castMasked}};
    GpuScene gpu = uploadScene(loaded, settings.records(), context.capabilities());
    Renderer renderer(settings, context.capabilities());
    VolumeTintPass tint(settings, context.capabilities());
    FrameView view = test::boundedFrame(scene, castMasked, request);
    Pictures result;
    view.mask = true;
    renderer.draw(gpu, view);
    result.mask = context.readPixels();
    view.mask = false;
    renderer.draw(gpu, view);
    result.plain = context.readPixels();
    FramePlan plan = renderer.plan();
    if (change) change(plan);
    tint.draw(gpu, view, plan, 0);
    gl::requireNoError("drawing a test scene");
    result.tinted = context.readPixels();
    return result;
}

/// Whether a pixel of the tinted picture is the plain one under `times` layers of a tint.
bool isUnder(const Pictures& pictures, std::size_t at, const glm::vec4& tint, int times) {
    for (glm::length_t c = 0; c < 3; ++c) {
        const double before = pictures.plain[at + static_cast<std::size_t>(c)];
        const double left = std::pow(1.0 - tint.a, times);
        const double expected = left * before + (1.0 - left) * 255.0 * tint[c];
        const double drawn = pictures.tinted[at + static_cast<std::size_t>(c)];
        if (std::abs(drawn - expected) > times + 0.5) return false;
    }
    return true;
}

FrameRequest request(const Camera& camera, const Light& light, int slices = 1) {
    FrameRequest result{
        frustumOf(camera, static_cast<double>(width) / height), width, height, {light}, {}};
    result.depth.slices = slices;
    return result;
}

const Scene boxOverFloor = SceneBuilder().floor(9).box({-1, 2, -1}, {1, 2.5, 1}).scene();
const Camera fromTheSide{{0.5, 4, 11}, {0, 1, 0}, 50.0};
const Light lampAbove = pointLight({0.4, 8, 0.3});

/// If a pixel's surface is in shadow, a box's volume in front of it is entered once more than it is
/// left: one orange layer; else none or two.
void expectSidesAreOrange(const Pictures& pictures) {
    int one = 0, two = 0;
    for (std::size_t at = 0; at < pictures.plain.size(); at += 4) {
        ASSERT_EQ(pictures.tinted[at + 3], pictures.plain[at + 3]);
        const bool surface = pictures.mask[at + 3] != 0, lit = pictures.mask[at] != 0;
        if (!surface) continue;
        const glm::vec4& orange = VolumeTintPass::tints.before;
        if (!lit) {
            // The box's own faces that are turned away are within its volume's outline.
            ASSERT_TRUE(isUnder(pictures, at, orange, 1) || isUnder(pictures, at, orange, 0))
                << "pixel " << at / 4;
            one += isUnder(pictures, at, orange, 1);
        } else {
            ASSERT_TRUE(isUnder(pictures, at, orange, 0) || isUnder(pictures, at, orange, 2))
                << "pixel " << at / 4;
            two += isUnder(pictures, at, orange, 2);
        }
    }
    EXPECT_GT(one, 100);
    EXPECT_GT(two, 100);
}

TEST(VolumeTint, SidesAreOrangeWhereTheyStandBeforeWhatIsVisible) {
    expectSidesAreOrange(pictures(boxOverFloor, request(fromTheSide, lampAbove)));
}

TEST(VolumeTint, EachSliceTintsThePixelsThatItHoldsAlone) {
    constexpr std::size_t slices = 3;
    const FrameRequest frame = request(fromTheSide, lampAbove, slices);
    const auto tintedBy = [&](std::optional<std::size_t> slice) {
        const Pictures drawn = pictures(boxOverFloor, frame, false, {}, [&](FramePlan& plan) {
            EXPECT_EQ(plan.slices.size(), slices);
            for (std::size_t s = 0; s < slices; ++s)
                if (slice && s != *slice) plan.slices[s].lights[0].counts[0].draws = {};
        });
        std::vector<bool> tinted;
        for (std::size_t at = 0; at < drawn.plain.size(); at += 4)
            tinted.push_back(
                !std::equal(&drawn.plain[at], &drawn.plain[at] + 4, &drawn.tinted[at]));
        return tinted;
    };
    const std::vector<bool> all = tintedBy(std::nullopt);
    std::vector<int> owners(all.size());
    int used = 0;
    for (std::size_t slice = 0; slice < slices; ++slice) {
        const std::vector<bool> own = tintedBy(slice);
        for (std::size_t i = 0; i < own.size(); ++i)
            owners[i] += own[i];
        used += std::count(own.begin(), own.end(), true) > 20;
    }
    for (std::size_t i = 0; i < all.size(); ++i)
        ASSERT_EQ(owners[i], all[i] ? 1 : 0) << "pixel " << i;
    EXPECT_GE(used, 2);
}

/// A sheet of an alpha-tested material takes caps: red sides, and a blue front cap on the sheet.
struct Leaf {
    Leaf() {
        Material leaf;
        leaf.alphaMode = AlphaMode::mask;
        scene = SceneBuilder()
                    .floor(9)
                    .material(leaf)
                    .quad({-1, 2, 1}, {1, 2, 1}, {1, 2, -1}, {-1, 2, -1})
                    .scene();
    }
    Scene scene;
    FrameRequest frame = request({{0.5, 7, 9}, {0, 1, 0}, 40.0}, lampAbove);

    /// The pixel that shows a point of the world.
    std::size_t pixelOf(const glm::dvec3& point) const {
        const glm::dvec4 clip =
            clipFromView(frame.frustum, 0.1) * frame.frustum.viewFromWorld * glm::dvec4(point, 1.0);
        const int x = static_cast<int>(0.5 * width * (1.0 + clip.x / clip.w));
        const int y = static_cast<int>(0.5 * height * (1.0 - clip.y / clip.w));
        return 4 * static_cast<std::size_t>(y * width + x);
    }
};

TEST(VolumeTint, CapsAreBlueAndTheirSidesRed) {
    const Leaf leaf;
    const Pictures drawn = pictures(leaf.scene, leaf.frame, true);
    const auto& tints = VolumeTintPass::tints;
    EXPECT_TRUE(isUnder(drawn, leaf.pixelOf({0.1, 2, 0.2}), tints.caps, 1));
    // In the middle of its shadow, in front of which its front side stands.
    EXPECT_EQ(drawn.mask[leaf.pixelOf({0.0, 0, 0.6})], 0);
    EXPECT_TRUE(isUnder(drawn, leaf.pixelOf({0.0, 0, 0.6}), tints.behind, 1));
    EXPECT_TRUE(isUnder(drawn, leaf.pixelOf({-5, 0, 2}), tints.behind, 0));
}

TEST(VolumeTint, ShowsThePlanThatItIsGivenAndNothingElse) {
    const Leaf leaf;
    const auto keepShape = [](std::optional<VolumeDraw::Shape> kept) {
        return [kept](FramePlan& plan) {
            for (auto* draws : {&plan.slices[0].lights[0].counts[0].draws.once,
                                &plan.slices[0].lights[0].counts[0].draws.twice})
                std::erase_if(*draws, [&](const VolumeDraw& draw) { return draw.shape != kept; });
        };
    };
    const auto& tints = VolumeTintPass::tints;
    const std::size_t onLeaf = leaf.pixelOf({0.1, 2, 0.2}), onShadow = leaf.pixelOf({0.0, 0, 0.6});
    const Pictures nothing = pictures(leaf.scene, leaf.frame, true, {}, keepShape({}));
    EXPECT_EQ(nothing.tinted, nothing.plain);
    const Pictures caps =
        pictures(leaf.scene, leaf.frame, true, {}, keepShape(VolumeDraw::Shape::caps));
    EXPECT_TRUE(isUnder(caps, onLeaf, tints.caps, 1));
    EXPECT_TRUE(isUnder(caps, onShadow, tints.behind, 0));
    const Pictures sides =
        pictures(leaf.scene, leaf.frame, true, {}, keepShape(VolumeDraw::Shape::sides));
    EXPECT_TRUE(isUnder(sides, onLeaf, tints.caps, 0));
    EXPECT_TRUE(isUnder(sides, onShadow, tints.behind, 1));
}

TEST(VolumeTint, WhatCountsTwiceIsGreen) {
    // A roof whose ridge is a silhouette: both of its sides cast, one of them turned away.
    const Scene roof = SceneBuilder()
                           .floor(9)
                           .quad({-1, 1, -1}, {-1, 1, 1}, {0, 3, 1}, {0, 3, -1})
                           .quad({0, 3, -1}, {0, 3, 1}, {1, 1, 1}, {1, 1, -1})
                           .scene();
    const FrameRequest frame = request({{6, 4, 8}, {1, 1, 0}, 50.0}, pointLight({-9, 6, 0.3}));
    const auto onlyTwice = [](FramePlan& plan) {
        plan.slices[0].lights[0].counts[0].draws.once.clear();
    };
    const Pictures drawn = pictures(roof, frame, false, {}, onlyTwice);
    int green = 0;
    for (std::size_t at = 0; at < drawn.plain.size(); at += 4) {
        const bool one = isUnder(drawn, at, VolumeTintPass::tints.twice, 1);
        ASSERT_TRUE(one || isUnder(drawn, at, VolumeTintPass::tints.twice, 0));
        green += one && !isUnder(drawn, at, VolumeTintPass::tints.twice, 0);
    }
    EXPECT_GT(green, 100);
}

TEST(VolumeTint, PublishedVolumesAreRedAndBlue) {
    RenderSettings settings;
    settings.multiplicity = MultiplicityMethod::referenceEdge;
    settings.rivals = &allRivals();
    const Pictures drawn = pictures(
        boxOverFloor, request(fromTheSide, lampAbove), false, settings, [](FramePlan& plan) {
            std::erase_if(
                plan.slices[0].lights[0].counts[0].draws.once,
                [](const VolumeDraw& draw) { return draw.shape != VolumeDraw::Shape::sides; });
        });
    // Every triangle counts, so that each silhouette edge has two sides.
    int red = 0;
    for (std::size_t at = 0; at < drawn.plain.size(); at += 4)
        red += isUnder(drawn, at, VolumeTintPass::tints.behind, 2) &&
               !isUnder(drawn, at, VolumeTintPass::tints.behind, 0);
    EXPECT_GT(red, 100);
}

} // namespace
} // namespace edgeshade
