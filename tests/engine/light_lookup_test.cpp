// A host that looks a light up in its own shader shows the shadows of `render --mask`.
#include "src/engine/light_lookups.hpp"
#include "tests/engine/host_picture.hpp"

#include <GLES2/gl2.h>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <stdexcept>

namespace edgeshade {
namespace {

using namespace test;

const Camera corner{{5, 4, 6}, {0, 0.5, 0}, 50.0};

} // namespace

TEST(LightLookup, IsWhatRenderDrawsForEveryKindOfLight) {
    const std::vector<Light> lights = {sun({0.5, 1, -0.3}), pointLight({0.3, 4, 0.7}), spot(),
                                       pointLight({-0.4, 1.1, 0.9})};
    std::vector<Mask> expected;
    for (const Light& light : lights)
        expected.push_back(renderedMask(yard().scene(), corner, light));
    const gl::HeadlessContext context({hostWidth, hostHeight});
    const Scene scene = yard().scene();
    ShadowMasks masks(eglLookUp);
    masks.add(meshOf(geometryOf(scene)));
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const MaskLight light = hostLight(lights[i]);
        const auto id = lookedUp(masks, light);
        EXPECT_TRUE(masks.isCurrent(id, light));
        EXPECT_GT(masks.lookup(id).bytes, 0u);
        for (const HostPicture::Language language : languages(context.capabilities())) {
            HostPicture(masks, id, light, viewOf(corner), language)
                .draw(geometryOf(scene), identity16, true);
            const Wrong wrong = compared(redOf(context), expected[i]);
            EXPECT_EQ(wrong.beyond, 0u)
                << "light " << i << ", " << language.version3 << language.derivatives;
            EXPECT_LE(wrong.all, 20u)
                << "light " << i << ", " << language.version3 << language.derivatives;
        }
    }
}

TEST(LightLookup, OfFewCastersHasFewTexels) {
    const gl::HeadlessContext context({hostWidth, hostHeight});
    const Scene scene = yard().scene();
    ShadowMasks masks(eglLookUp);
    masks.add(meshOf(geometryOf(scene)));
    const MaskLight light = hostLight(pointLight({0.3, 4, 0.7}));
    EXPECT_EQ(masks.lookup(lookedUp(masks, light)).size, 16.0f);
    EXPECT_EQ(masks.lookup(lookedUp(masks, light, {8})).size, 8.0f) << "and no more than asked";
}

TEST(LightLookup, IsTheSameFarFromTheOrigin) {
    const Light light = sun({0.5, 1, -0.3});
    const Mask expected = renderedMask(yard().scene(), corner, light);
    const gl::HeadlessContext context({hostWidth, hostHeight});
    const Scene scene = yard().scene();
    const glm::dmat4 far = glm::translate(glm::dmat4(1.0), {4.4e6, 530.0, 5.3e6});
    ShadowMasks masks(eglLookUp);
    masks.add(meshOf(geometryOf(scene)), numbersOf(far));
    const MaskLight asked = hostLight(light);
    const auto id = lookedUp(masks, asked);
    const glm::dvec3 moved(far[3]);
    const MaskView view = viewOf({corner.from + moved, corner.to + moved, 50.0});
    HostPicture(masks, id, asked, view, {}).draw(geometryOf(scene), numbersOf(far), true);
    EXPECT_EQ(compared(redOf(context), expected).beyond, 0u);
}

TEST(LightLookup, TellsSurfacesThatOnlyReceive) {
    const gl::HeadlessContext context({hostWidth, hostHeight});
    const Scene scene = yard().scene();
    const Scene pane = SceneBuilder().box({-3, 0.6f, 1.2f}, {3, 2.2f, 1.21f}).scene();
    for (const Light& from : {sun({0.5, 1, -0.3}), sun({0.3, 0.5, 1}), pointLight({0.3, 3, -1})}) {
        const MaskLight light = hostLight(from);
        ShadowMasks masks(eglLookUp);
        masks.add(meshOf(geometryOf(scene)));
        const auto id = lookedUp(masks, light);
        MaskMesh receiver = meshOf(geometryOf(pane));
        receiver.casts = false;
        masks.add(receiver);
        EXPECT_TRUE(masks.isCurrent(id, light)) << "it casts nothing";
        masks.draw(viewOf(corner), {&light, 1});
        const Mask expected = readMask(masks, 0);
        HostPicture picture(masks, id, light, viewOf(corner), {});
        picture.draw(geometryOf(scene), identity16, true);
        picture.draw(geometryOf(pane), identity16, false);
        const Wrong wrong = compared(redOf(context), expected);
        EXPECT_EQ(wrong.beyond, 0u);
        EXPECT_LE(wrong.all, 20u);
    }
}

TEST(LightLookup, ShadesTheBacksOfOpenSheets) {
    // Seen between two sheets, the lower one shows the light its back.
    const auto sheets = [](bool turned) {
        SceneBuilder builder;
        builder.quad({-4, 1, -4}, {-4, 1, 4}, {4, 1, 4}, {4, 1, -4});
        if (turned)
            builder.quad({-4, 0.8f, -4}, {4, 0.8f, -4}, {4, 0.8f, 4}, {-4, 0.8f, 4});
        else
            builder.quad({-4, 0.8f, -4}, {-4, 0.8f, 4}, {4, 0.8f, 4}, {4, 0.8f, -4});
        return builder.scene();
    };
    const Camera between{{6, 0.95, 0.3}, {0, 0.85, 0}, 50.0};
    for (const Light& from : {sun({0.9, 0.35, 0.1}), pointLight({9, 4, 0.5})})
        for (const bool turned : {false, true}) {
            const Mask expected = renderedMask(sheets(turned), between, from);
            EXPECT_GT(std::count(expected.begin(), expected.end(), 0), 200);
            const gl::HeadlessContext context({hostWidth, hostHeight});
            const Scene scene = sheets(turned);
            ShadowMasks masks(eglLookUp);
            masks.add(meshOf(geometryOf(scene)));
            const MaskLight light = hostLight(from);
            const auto id = lookedUp(masks, light);
            for (const HostPicture::Language language : languages(context.capabilities())) {
                HostPicture(masks, id, light, viewOf(between), language)
                    .draw(geometryOf(scene), identity16, true);
                EXPECT_EQ(compared(redOf(context), expected).beyond, 0u) << turned;
            }
        }
}

TEST(LightLookup, ShowsNoFringesUnderMultisampling) {
    const Light light = sun({0.5, 1, -0.3});
    const Mask expected = renderedMask(yard().scene(), corner, light);
    if (!gl::HeadlessContext({1, 1}).capabilities().multisampling)
        GTEST_SKIP() << "no multisampling here";
    const gl::HeadlessContext context({hostWidth, hostHeight, 4});
    const Scene scene = yard().scene();
    ShadowMasks masks(eglLookUp);
    masks.add(meshOf(geometryOf(scene)));
    const MaskLight asked = hostLight(light);
    const auto id = lookedUp(masks, asked);
    HostPicture(masks, id, asked, viewOf(corner), {}).draw(geometryOf(scene), identity16, true);
    const Mask drawn = redOf(context);
    // A corner that only the samples show; masks read at pixels differ at hundreds.
    EXPECT_LE(compared(drawn, expected).beyond, 2u);
    EXPECT_TRUE(std::any_of(drawn.begin(), drawn.end(), [](std::uint8_t share) {
        return share > 0 && share < 255;
    })) << "there should be samples";
}

TEST(LightLookup, IsOutOfDateOnceACasterOrTheLightIsElsewhere) {
    const gl::HeadlessContext context({hostWidth, hostHeight});
    const Scene scene = yard().scene(), box = SceneBuilder().box({-1, 2, -1}, {1, 2.5f, 1}).scene();
    const Matrix16 aside = numbersOf(glm::translate(glm::dmat4(1.0), {0.5, 0, 0}));
    MaskLight light = hostLight(sun({0.5, 1, -0.3}));
    ShadowMasks masks(eglLookUp);
    masks.add(meshOf(geometryOf(scene)));
    MaskMesh receiver = meshOf(geometryOf(box));
    receiver.casts = false;
    const auto caster = masks.add(meshOf(geometryOf(box)), aside), other = masks.add(receiver);
    const LookupSettings ofAll{.restMs = 0.0};
    auto id = lookedUp(masks, light, ofAll);
    const auto renewed = [&] {
        const bool current = masks.isCurrent(id, light);
        masks.removeLookup(id);
        id = lookedUp(masks, light, ofAll);
        return !current;
    };
    masks.move(caster, aside);
    masks.move(other, aside);
    EXPECT_FALSE(renewed()) << "nothing that casts has moved";
    masks.move(caster, identity16);
    EXPECT_TRUE(renewed());
    masks.change(caster, meshOf(geometryOf(scene)));
    EXPECT_TRUE(renewed());
    masks.remove(caster);
    EXPECT_TRUE(renewed());
    light.range = 3.0;
    EXPECT_FALSE(renewed()) << "shadows don't depend on it";
    masks.add(meshOf(geometryOf(box)));
    EXPECT_TRUE(renewed());
    light.direction = {0, -1, 0.1};
    EXPECT_FALSE(masks.isCurrent(id, light));
}

TEST(LightLookup, SaysWhyThereIsNone) {
    const gl::HeadlessContext context({hostWidth, hostHeight});
    const auto none = gl::limited(context.capabilities(), gl::Limits::es2Minimum);
    EXPECT_EQ(LightLookups(none).obstacle(), "the GL can't sample float textures exactly");
    ShadowMasks masks(eglLookUp);
    masks.add(meshOf(geometryOf(yard().scene())));
    MaskLight light = hostLight(pointLight({0.3, 400, 0.7}));
    const auto why = [&](const LookupSettings& settings) {
        return masks.lookup(lookedUp(masks, light, settings)).why;
    };
    EXPECT_EQ(why({}), "the light is too far from its casters for a primitive map");
    light.position = {0.3, 4, 0.7};
    EXPECT_EQ(why({}), "");
    EXPECT_EQ(why({512, 1000}),
              "a primitive map would take more than 1000 bytes, or minutes to build");
    light.radius = 0.1;
    EXPECT_EQ(why({.restMs = 0.0}), "") << "a light with a radius";
}

TEST(LightLookup, RefusesWhatIsWrongInASentence) {
    const gl::HeadlessContext context({hostWidth, hostHeight});
    ShadowMasks masks(eglLookUp);
    masks.add(meshOf(geometryOf(yard().scene())));
    const MaskLight light;
    EXPECT_THROW(masks.lookupWork(light, {500}), std::runtime_error);
    EXPECT_THROW(masks.lookup(3), std::runtime_error);
    LookupWork work = masks.lookupWork(light);
    EXPECT_THROW(masks.addLookup(work), std::runtime_error) << "not done";
    while (!work.advance(1.0)) {
    }
    masks.addLookup(work);
    EXPECT_THROW(masks.addLookup(work), std::runtime_error) << "added twice";
    for (const char* prefix : {"", "1a", "a_", "a__b", "gl_a", "a-b"})
        EXPECT_THROW(lookupSource(prefix), std::runtime_error) << prefix;
}

} // namespace edgeshade
