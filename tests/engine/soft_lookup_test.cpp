// A host that looks up a light with a radius in its own shader counts the light's points as rays
// do.
#include "src/lab/point_counts.hpp"
#include "src/shadow/lights/light_extent.hpp"
#include "tests/engine/host_picture.hpp"
#include "tests/support/bounded_frame.hpp"
#include "tests/support/extended_lights.hpp"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <stdexcept>

namespace edgeshade {
namespace {

using namespace test;

const Camera corner{{5, 4, 6}, {0, 0.5, 0}, 50.0};
const lab::AlphaLookup opaque{[](auto&&...) { return 1.0f; }, {}};
constexpr LookupSettings all{.restMs = 0.0}; // casters

struct Case {
    Scene scene;
    Camera camera;
    Light light;
    std::size_t points = 40;
};

/// Compares the shares that a host's shader finds with rays to each point of the light.
void expectRight(const Case& of, double mostPercent = 0.05) {
    FrameRequest request{.frustum = frustumOf(of.camera, double{hostWidth} / hostHeight),
                         .width = hostWidth,
                         .height = hostHeight,
                         .lights = {of.light}};
    request.lightSamples = of.points;
    const FrameView view = boundedFrame(of.scene, false, request);
    lab::PointOracle oracle({&of.scene, false, view.frustum, view.near(),
                             lightPoints(of.light, of.points), hostWidth, hostHeight},
                            opaque);
    const gl::HeadlessContext context({hostWidth, hostHeight});
    const Geometry& whole = geometryOf(of.scene);
    ShadowMasks masks(eglLookUp);
    const Matrix16 place = numbersOf(of.scene.batches.front().worldFromBatch);
    masks.add(meshOf(whole), place);
    const MaskLight light = hostLight(of.light);
    const auto id = lookedUp(masks, light, {.restMs = 0.0, .lightSamples = of.points});
    ASSERT_EQ(masks.lookup(id).why, "");
    EXPECT_TRUE(masks.isCurrent(id, light));
    for (HostPicture::Language language : languages(context.capabilities())) {
        SCOPED_TRACE(testing::Message() << language.version3 << language.derivatives);
        language.soft = true;
        HostPicture(masks, id, light, viewOf(of.camera), language).draw(whole, place, true);
        LitCounts counts{hostWidth, hostHeight, static_cast<std::uint32_t>(of.points), 1, {}, {}};
        const std::vector<std::uint8_t> rgba = context.readPixels();
        for (std::size_t i = 0; i < rgba.size(); i += 4) {
            const bool isSurface = rgba[i + 3] > 0;
            const double share = isSurface ? rgba[i] / 255.0 : 0.0;
            counts.lit.push_back(
                static_cast<std::uint16_t>(std::lround(share * static_cast<double>(of.points))));
            counts.surface.push_back(isSurface);
        }
        const lab::WrongSums sums = oracle.compare(counts, of.points);
        EXPECT_GT(sums.visiblePixels, 3000u);
        EXPECT_LE(sums.percent(), mostPercent);
        EXPECT_EQ(sums.beyond1pxNotTied, 0u);
    }
}

} // namespace

TEST(SoftLookup, CountsPointsOfSunsAndLampsAsRaysDo) {
    expectRight({yard().scene(), corner, sphereAt({0.3, 4, 0.7}, 0.5)});
    expectRight({yard().scene(), corner, sphereAt({-0.4, 1.1, 0.9}, 0.2)});
    expectRight({yard().scene(), corner, discTowards({0.5, 1, -0.3}, 6.0)});
    expectRight({yard().scene(), corner, discTowards({0.5, 1, -0.3}, 0.5), 64});
}

TEST(SoftLookup, CountsWhereSurfacesPartTheLight) {
    const Scene wall = SceneBuilder()
                           .floor(5)
                           .quad({-3, 0, -1}, {3, 0, -1}, {3, 3, -1}, {-3, 3, -1})
                           .box({-0.5f, 0, 0.2f}, {0.5f, 1, 1})
                           .scene();
    expectRight({wall, corner, sphereAt({0.2, 1.5, -1}, 0.4)}, 0.2);
    expectRight({yard().scene(), corner, sphereAt({0.6, 0.3, 1.4}, 0.3)}, 0.2);
    expectRight({yard().scene(), corner, discTowards({1, 0.002, 0.4}, 4.0)}, 0.3);
}

TEST(SoftLookup, IsTheSameFarFromTheOriginAndInOtherUnits) {
    const auto placed = [](const glm::dmat4& place) {
        const double scale = place[0][0];
        const glm::dvec3 at(place[3]);
        return Case{yard().placedBy(place).scene(),
                    {scale * corner.from + at, scale * corner.to + at, 50.0},
                    sphereAt(scale * glm::dvec3(0.3, 4, 0.7) + at, scale * 0.5),
                    16};
    };
    for (const double scale : {0.1, 100.0})
        expectRight(placed(glm::dmat4(glm::dmat3(scale))));
    expectRight(placed(glm::translate(glm::dmat4(1.0), {4.4e6, 530.0, 5.3e6})));
}

TEST(SoftLookup, ReachesReceiversBehindTheCasters) {
    // The floor is far below the casters: penumbras there are wide.
    const gl::HeadlessContext context({hostWidth, hostHeight});
    const Scene box = SceneBuilder().box({-1, 2, -1}, {1, 2.5f, 1}).scene(),
                floor = SceneBuilder().floor(5).scene();
    const MaskLight light = hostLight(discTowards({0.2, 1, 0.1}, 20.0));
    for (const bool isAdded : {true, false}) {
        ShadowMasks masks(eglLookUp);
        masks.add(meshOf(geometryOf(box)));
        MaskMesh receiver = meshOf(geometryOf(floor));
        receiver.casts = false;
        std::optional<ShadowMasks::Id> ground;
        if (isAdded)
            ground = masks.add(receiver);
        else
            masks.setReceivers({-5, 0, -5}, {5, 0, 5});
        const auto id = lookedUp(masks, light, all);
        HostPicture picture(masks, id, light, viewOf(corner), {.soft = true});
        picture.draw(geometryOf(box), identity16, true);
        picture.draw(geometryOf(floor), identity16, false);
        const Mask drawn = redOf(context);
        EXPECT_TRUE(masks.isCurrent(id, light));
        const Matrix16 below = numbersOf(glm::translate(glm::dmat4(1.0), {0, -9, 0}));
        if (ground)
            masks.move(*ground, below);
        else
            masks.setReceivers({-5, -9, -5}, {5, -9, 5});
        EXPECT_FALSE(masks.isCurrent(id, light)) << "the floor is out of reach";
        if (!ground)
            ground = masks.add(receiver);
        else
            masks.move(*ground, identity16);
        masks.setReceivers({0, 0, 0}, {NAN, 0, 0});
        EXPECT_TRUE(masks.isCurrent(id, light));
        masks.draw(viewOf(corner), {&light, 1});
        const Mask masked = readMask(masks, 0);
        std::size_t grey = 0, wrong = 0;
        for (std::size_t i = 0; i < drawn.size(); ++i) {
            grey += masked[i] > 0 && masked[i] < 255;
            wrong += std::abs(drawn[i] - masked[i]) > 4;
        }
        EXPECT_GT(grey, 1000u);
        EXPECT_LE(wrong, 20u) << isAdded;
    }
}

TEST(SoftLookup, HoldsAllCastersOrSaysWhyThereIsNone) {
    const gl::HeadlessContext context({hostWidth, hostHeight});
    const Scene box = SceneBuilder().box({-1, 2, -1}, {1, 2.5f, 1}).scene();
    MaskLight light = hostLight(sphereAt({0.3, 4, 0.7}, 0.2));
    ShadowMasks masks(eglLookUp);
    masks.add(meshOf(geometryOf(yard().scene())));
    const auto why = [&](const LookupSettings& settings) {
        return masks.lookup(lookedUp(masks, light, settings)).why;
    };
    const auto id = lookedUp(masks, light, all);
    EXPECT_TRUE(masks.isCurrent(id, light));
    light.range = 3.0;
    EXPECT_TRUE(masks.isCurrent(id, light)) << "the host's shader draws ranges";
    light.radius = 0.3;
    EXPECT_FALSE(masks.isCurrent(id, light)) << "it is another radius";
    light.radius = 0.2;
    const auto caster = masks.add(meshOf(geometryOf(box)));
    EXPECT_FALSE(masks.state(id, light).holds) << "shares of movers can't be counted on top";
    EXPECT_THROW(masks.draw(viewOf(corner), {&light, 1}, {&id, 1}), std::runtime_error);
    masks.move(caster, numbersOf(glm::translate(glm::dmat4(1.0), {0.5, 0, 0})));
    EXPECT_EQ(why({}), "it has a radius, and casters move");
    EXPECT_EQ(why(all), "");
    EXPECT_EQ(
        why({.restMs = 0.0, .lightSamples = 4096}),
        "a list in its primitive map would have 15 triangles, more than a shader loop can test");
    masks.setTint(caster, {{1.0f, 0.5f, 0.2f}});
    EXPECT_EQ(why(all), "") << "it casts as in masks";
    EXPECT_EQ(why({.restMs = 0.0, .casters = {.tints = true}}),
              "it has a radius, and cutouts or tints cast");
    EXPECT_THROW(masks.lookupWork(light, {.lightSamples = 0}), std::runtime_error);
    EXPECT_THROW(masks.lookupWork(light, {.lightSamples = 4097}), std::runtime_error);
}

} // namespace edgeshade
