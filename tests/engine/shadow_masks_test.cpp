// The mask engine gives a host the same masks as `render --mask`, whatever was added, removed or
// moved before.
#include "src/shadow/lights/light_extent.hpp"
#include "tests/engine/masks_in_a_host.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <numeric>
#include <stdexcept>

namespace edgeshade {
namespace {

using namespace test;

const Camera corner{{5, 4, 6}, {0, 0.5, 0}, 50.0};

/// Both masks; the host's is for one of several lights. The rendered one is drawn first, in its own
/// context, so that contexts don't interfere.
struct Expected {
    Scene scene;
    Light light;
    std::vector<std::uint8_t> mask;

    Expected(Scene of, const Light& by) : scene(std::move(of)), light(by) {
        mask = renderedMask(scene, corner, light);
    }
};

std::size_t shadowed(const std::vector<std::uint8_t>& mask) {
    return static_cast<std::size_t>(std::count(mask.begin(), mask.end(), 0));
}

Scene boxAt(const glm::dmat4& place) {
    return SceneBuilder().box({-0.5f, 0.2f, -0.5f}, {0.5f, 1.0f, 0.5f}).placedBy(place).scene();
}

Scene yardWith(const glm::dmat4& place) {
    Scene scene = yard().scene();
    scene.batches.push_back(boxAt(place).batches.front());
    return scene;
}

const glm::dmat4 left = glm::translate(glm::dmat4(1.0), {-1.5, 0.5, 2.0});
const glm::dmat4 right = glm::rotate(glm::translate(glm::dmat4(1.0), {2.2, 1.0, 1.0}), 0.7,
                                     glm::normalize(glm::dvec3(1, 2, 3)));

} // namespace

TEST(ShadowMasks, AreThoseOfRenderForEveryKindOfLight) {
    const std::vector<Light> lights = {sun({0.5, 1, -0.3}), pointLight({0.3, 4, 0.7}), spot(),
                                       Light{{0.2, 2.5, 1.2, 1.0}, 3.3},
                                       pointLight({-0.4, 1.1, 0.9})};
    std::vector<Expected> expected;
    for (const Light& light : lights)
        expected.emplace_back(yard().scene(), light);
    const gl::HeadlessContext context({hostWidth, hostHeight});
    ShadowMasks masks(eglLookUp);
    masks.add(meshOf(geometryOf(yard().scene())));
    std::vector<MaskLight> asked;
    for (const Light& light : lights)
        asked.push_back(hostLight(light));
    masks.draw(viewOf(corner), asked);
    EXPECT_EQ(masks.textures().size(), 2u) << "four lights a texture";
    for (std::size_t i = 0; i < lights.size(); ++i) {
        EXPECT_EQ(readMask(masks, i), expected[i].mask) << "light " << i;
        EXPECT_GT(shadowed(expected[i].mask), 500u) << "there should be shadows";
    }
    EXPECT_GT(masks.cost().bytes, 0u);
    EXPECT_GT(masks.cost().vertexRuns, 0u);
    EXPECT_EQ(masks.cost().hostError, 0u);
}

TEST(ShadowMasks, MadeAheadAreTheSame) {
    const Light light = spot();
    const Expected expected(yard().scene(), light);
    const gl::HeadlessContext context({hostWidth, hostHeight});
    ShadowMasks masks(eglLookUp);
    const MaskLight asked = hostLight(light);
    MaskView view = viewOf(corner);
    EXPECT_TRUE(masks.prepareToDraw(view, {&asked, 1})) << "this GL links within the call";
    EXPECT_GE(masks.textures().size(), 1u) << "its textures are there";
    masks.add(meshOf(geometryOf(yard().scene())));
    masks.draw(view, {&asked, 1});
    EXPECT_EQ(readMask(masks, 0), expected.mask);
    view.width = 0;
    EXPECT_THROW(masks.prepareToDraw(view, {&asked, 1}), std::runtime_error);
    const std::vector<MaskLight> many(ShadowMasks::mostLights + 1);
    EXPECT_THROW(masks.prepareToDraw(viewOf(corner), many), std::runtime_error);
}

TEST(ShadowMasks, PlannedAheadAreTheSame) {
    const std::vector<Light> lights = {spot(), sun({0.3, 1, 0.2})};
    const Expected first(yardWith(left), lights[0]), second(yardWith(left), lights[1]);
    const gl::HeadlessContext context({hostWidth, hostHeight});
    ShadowMasks masks(eglLookUp);
    const std::vector<MaskLight> asked = {hostLight(lights[0]), hostLight(lights[1])};
    MaskView view = viewOf(corner);
    const Scene ground = yard().scene(), box = boxAt(glm::dmat4(1.0));
    const auto stepsOf = [&] {
        std::size_t steps = 1;
        while (!masks.planAhead(view, asked) && steps < 20)
            ++steps;
        return steps;
    };
    masks.add(meshOf(geometryOf(ground)));
    EXPECT_EQ(stepsOf(), 7u) << "tree, uploads, bounds, layers, two lists, and their upload";
    EXPECT_EQ(stepsOf(), 1u);
    masks.add(meshOf(geometryOf(box)), numbersOf(left));
    EXPECT_EQ(stepsOf(), 7u);
    masks.draw(view, asked);
    EXPECT_EQ(readMask(masks, 0), first.mask);
    EXPECT_EQ(readMask(masks, 1), second.mask);
    EXPECT_EQ(stepsOf(), 1u) << "all of it is kept";

    const std::vector<ShadowMasks::LookupId> one = {ShadowMasks::noLookup};
    EXPECT_THROW(masks.planAhead(view, asked, one), std::runtime_error);
    view.width = 0;
    EXPECT_THROW(masks.planAhead(view, asked), std::runtime_error);
}

TEST(ShadowMasks, ListsOfLargeMeshesArePlannedInStepsOfTheirOwn) {
    const gl::HeadlessContext context({hostWidth, hostHeight});
    const Scene ground = yard().scene();
    std::vector<float> meadow; // more records than a step lists
    for (int i = 0; i < 12000; ++i) {
        const auto x = static_cast<float>(i % 120) / 40.0f, z = static_cast<float>(i / 120) / 40.0f;
        meadow.insert(meadow.end(), {x, 0.4f, z, x + 0.02f, 0.4f, z, x, 0.44f, z + 0.01f});
    }
    std::vector<std::uint32_t> indices(meadow.size() / 3);
    std::iota(indices.begin(), indices.end(), 0u);
    const PreparedMesh prepared(MaskMesh{.positions = meadow, .indices = indices});
    const auto addTo = [&](ShadowMasks& masks) {
        masks.add(meshOf(geometryOf(ground)));
        for (const double at : {-3.0, -1.0, 1.0}) {
            const glm::dmat4 there = glm::translate(glm::dmat4(1.0), {at, 0, at});
            masks.add(prepared, numbersOf(glm::rotate(there, at, {0, 1, 0})));
        }
    };
    ShadowMasks masks(eglLookUp), others(eglLookUp);
    addTo(masks);
    addTo(others);
    const MaskLight light = hostLight(sun({0.3, 1, 0.2}));
    others.draw(viewOf(corner), {&light, 1});
    const std::vector<std::uint8_t> expected = readMask(others, 0);
    std::size_t steps = 1;
    while (!masks.planAhead(viewOf(corner), {&light, 1}) && steps < 20)
        ++steps;
    EXPECT_EQ(steps, 11u)
        << "tree, uploads, bounds, layers, lists of three places, and their upload";
    masks.draw(viewOf(corner), {&light, 1});
    EXPECT_EQ(readMask(masks, 0), expected);
}

TEST(ShadowMasks, ProgramsOfExpectedMeshesAreMadeAhead) {
    const Light light = spot();
    const Scene block = SceneBuilder().box({-0.5f, 0.0f, -0.5f}, {0.5f, 0.5f, 0.5f}).scene();
    const Scene sheet = SceneBuilder().floor(0.4f, 1.0f).scene();
    std::vector<std::vector<std::uint8_t>> drawn;
    for (const bool ahead : {false, true}) {
        const gl::HeadlessContext context({hostWidth, hostHeight});
        ShadowMasks masks(eglLookUp);
        const MaskLight asked = hostLight(light);
        const MaskView view = viewOf(corner);
        const PreparedMesh closed(meshOf(geometryOf(block))), open(meshOf(geometryOf(sheet)));
        masks.add(closed);
        EXPECT_TRUE(masks.prepareToDraw(view, {&asked, 1}));
        masks.draw(view, {&asked, 1});
        const std::vector<std::uint8_t> before = readMask(masks, 0);
        masks.expect(open);
        EXPECT_FALSE(masks.isPrepared());
        if (ahead) {
            EXPECT_TRUE(masks.prepareToDraw(view, {&asked, 1}));
            EXPECT_TRUE(masks.isPrepared());
            EXPECT_EQ(readMask(masks, 0), before) << "the last pictures stay";
        }
        masks.add(open);
        masks.draw(view, {&asked, 1});
        drawn.push_back(readMask(masks, 0));
        EXPECT_NE(drawn.back(), before) << "the sheet casts";
    }
    EXPECT_EQ(drawn[0], drawn[1]) << "a draw makes what is missing";
}

TEST(ShadowMasks, FollowWhatComesGoesMovesAndChanges) {
    const Light light = pointLight({0.3, 4, 0.7});
    const Expected alone(yard().scene(), light), withLeft(yardWith(left), light),
        withRight(yardWith(right), light);
    const gl::HeadlessContext context({hostWidth, hostHeight});
    ShadowMasks masks(eglLookUp);
    const Scene ground = yard().scene(), box = boxAt(glm::dmat4(1.0));
    const auto drawn = [&] {
        const MaskLight asked = hostLight(light);
        masks.draw(viewOf(corner), {&asked, 1});
        return readMask(masks, 0);
    };
    masks.add(meshOf(geometryOf(ground)));
    EXPECT_EQ(drawn(), alone.mask);
    auto id = masks.add(meshOf(geometryOf(box)), numbersOf(left));
    EXPECT_EQ(drawn(), withLeft.mask);
    masks.move(id, numbersOf(right));
    EXPECT_EQ(drawn(), withRight.mask);
    EXPECT_EQ(masks.cost().buildMs, 0.0) << "nothing is made anew of what moves";
    masks.remove(id);
    EXPECT_EQ(drawn(), alone.mask);
    const Scene other = SceneBuilder().box({-2, 3, -2}, {2, 3.2f, 2}).scene();
    id = masks.add(meshOf(geometryOf(other)), numbersOf(left));
    EXPECT_NE(drawn(), withLeft.mask);
    masks.change(id, meshOf(geometryOf(box)));
    EXPECT_EQ(drawn(), withLeft.mask);
    EXPECT_NE(withLeft.mask, alone.mask);
    EXPECT_NE(withLeft.mask, withRight.mask);
}

TEST(ShadowMasks, OfAMeshAtTwoPlacesAreThoseOfTwoMeshes) {
    const glm::dmat4 left = glm::translate(glm::dmat4(1.0), {-1.5, 0, 0.5});
    const glm::dmat4 right = glm::translate(glm::dmat4(1.0), {1.2, 0.3, -0.4});
    const MaskLight light = hostLight(sun({0.5, 1, -0.3}));
    const gl::HeadlessContext context({hostWidth, hostHeight});
    const Scene ground = yard().scene(), box = boxAt(glm::dmat4(1.0));
    const auto drawn = [&](ShadowMasks& masks) {
        masks.draw(viewOf(corner), {&light, 1});
        return readMask(masks, 0);
    };
    ShadowMasks twice(eglLookUp), places(eglLookUp);
    for (ShadowMasks* masks : {&twice, &places})
        masks->add(meshOf(geometryOf(ground)));
    twice.add(meshOf(geometryOf(box)), numbersOf(left));
    twice.add(meshOf(geometryOf(box)), numbersOf(right));
    const PreparedMesh mesh(meshOf(geometryOf(box)));
    const auto first = places.add(mesh, numbersOf(left));
    const auto second = places.add(mesh, numbersOf(right));
    EXPECT_EQ(drawn(places), drawn(twice));
    EXPECT_LT(places.cost().bytes, twice.cost().bytes) << "they are kept once";
    // The first may be removed and the other changed: they don't affect each other.
    places.remove(first);
    ShadowMasks one(eglLookUp);
    one.add(meshOf(geometryOf(ground)));
    one.add(meshOf(geometryOf(box)), numbersOf(right));
    EXPECT_EQ(drawn(places), drawn(one));
    const auto third = places.add(mesh, numbersOf(left));
    places.change(second, meshOf(geometryOf(ground)));
    places.remove(second);
    places.move(third, numbersOf(right));
    EXPECT_EQ(drawn(places), drawn(one));
}

TEST(ShadowMasks, SeeThroughTheBacksOfWhatHasOneSide) {
    const MaskLight light = hostLight(sun({0.5, 1, -0.3}));
    const gl::HeadlessContext context({hostWidth, hostHeight});
    const Scene ground = yard().scene();
    // A triangle that hides much of the picture, wound clockwise as seen by the eye.
    const std::vector<float> positions = {4, 3, 4, -1, 5, 4.5, 3, 0.5, 6};
    const std::vector<std::uint32_t> front = {0, 1, 2}, back = {0, 2, 1};
    const auto drawn = [&](const std::vector<std::uint32_t>& indices, bool doubleSided) {
        ShadowMasks masks(eglLookUp);
        masks.add(meshOf(geometryOf(ground)));
        masks.add({positions, indices, false, doubleSided});
        masks.draw(viewOf(corner), {&light, 1});
        return readMask(masks, 0);
    };
    ShadowMasks alone(eglLookUp);
    alone.add(meshOf(geometryOf(ground)));
    alone.draw(viewOf(corner), {&light, 1});
    const auto without = readMask(alone, 0), hidden = drawn(front, true);
    EXPECT_EQ(drawn(back, true), hidden);
    ASSERT_NE(hidden, without);
    EXPECT_TRUE((drawn(front, false) == without) != (drawn(back, false) == without));
    EXPECT_TRUE((drawn(front, false) == hidden) != (drawn(back, false) == hidden));
}

/// Depth of each pixel according to nearness(), rows bottom to top; 0: no surface.
std::vector<double> depthsTold(const ShadowMasks& masks, bool orthographic) {
    const MaskNearness& told = masks.nearness();
    const std::vector<std::uint8_t> rgba = readTexture(told.texture);
    std::vector<double> depths;
    for (std::size_t i = 0; i < rgba.size(); i += 4) {
        const double nearness =
            (65536.0 * rgba[i] + 256.0 * rgba[i + 1] + rgba[i + 2]) / 16777215.0;
        depths.push_back(nearness == 0.0 ? 0.0
                         : orthographic  ? (nearness - told.offset) / told.scale
                                         : told.scale / (nearness - told.offset));
    }
    return depths;
}

TEST(ShadowMasks, TellHowFarAwaySurfacesAre) {
    const gl::HeadlessContext context({hostWidth, hostHeight});
    const MaskLight light = hostLight(sun({0.5, 1, -0.3}));
    // A square of half-width 1, parallel to the picture, 3 in front of the eye.
    const std::vector<float> positions = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0};
    const std::vector<std::uint32_t> indices = {0, 1, 2, 0, 2, 3};
    const Camera straight{{0, 0, 3}, {0, 0, 0}, 50.0};
    for (const bool orthographic : {false, true}) {
        ShadowMasks masks(eglLookUp);
        masks.add({positions, indices});
        MaskView view = viewOf(straight);
        if (orthographic) {
            const Frustum frustum =
                frustumOf(straight, static_cast<double>(hostWidth) / hostHeight, 4.0);
            view.clipFromView = numbersOf(clipFromView(frustum, 0.1, 10.0));
        }
        masks.draw(view, {&light, 1});
        EXPECT_EQ(masks.nearness().texture, 0u) << "nobody asked";
        view.nearness = true;
        masks.draw(view, {&light, 1});
        const std::vector<double> depths = depthsTold(masks, orthographic);
        EXPECT_NEAR(depths[hostHeight / 2 * hostWidth + hostWidth / 2], 3.0, 1e-5);
        EXPECT_EQ(depths.front(), 0.0);
    }
}

TEST(ShadowMasks, OfALightWithAnExtentAreShares) {
    const gl::HeadlessContext context({hostWidth, hostHeight});
    ShadowMasks masks(eglLookUp);
    masks.add(meshOf(geometryOf(yard().scene())));
    MaskLight light = hostLight(pointLight({0.3, 4, 0.7}));
    light.radius = 0.5;
    MaskView view = viewOf(corner);
    view.lightSamples = 5;
    masks.draw(view, {&light, 1});
    std::set<int> shares;
    for (const std::uint8_t share : readMask(masks, 0))
        shares.insert(share);
    EXPECT_EQ(shares, (std::set<int>{0, 51, 102, 153, 204, 255}));
}

TEST(ShadowMasks, OfASpotWithAnExtentAreTheSharesOfItsPoints) {
    Light light = spot();
    light.extent = LightExtent{.shape = LightExtent::Shape::sphere, .radius = 0.4};
    constexpr std::size_t points = 7;
    std::vector<unsigned> lit(std::size_t{hostWidth} * hostHeight, 0);
    for (const Light& point : lightPoints(light, points)) {
        const auto mask = renderedMask(yard().scene(), corner, point);
        for (std::size_t i = 0; i < lit.size(); ++i)
            lit[i] += mask[i] != 0;
    }
    std::vector<std::uint8_t> expected;
    for (const unsigned count : lit)
        expected.push_back(static_cast<std::uint8_t>((255 * count + points / 2) / points));
    const gl::HeadlessContext context({hostWidth, hostHeight});
    ShadowMasks masks(eglLookUp);
    masks.add(meshOf(geometryOf(yard().scene())));
    MaskView view = viewOf(corner);
    view.lightSamples = points;
    const MaskLight asked = hostLight(light);
    masks.draw(view, {&asked, 1});
    const auto drawn = readMask(masks, 0);
    std::size_t different = 0;
    for (std::size_t i = 0; i < drawn.size(); ++i)
        different += drawn[i] != expected[i];
    EXPECT_LE(different, 2u) << "points that are counted together share what they are planned by";
    EXPECT_EQ(std::set<std::uint8_t>(expected.begin(), expected.end()).size(), points + 1)
        << "there should be all shares";
}

TEST(ShadowMasks, AreLitWhereNothingIs) {
    const gl::HeadlessContext context({hostWidth, hostHeight});
    ShadowMasks masks(eglLookUp);
    const MaskLight light;
    masks.draw(viewOf(corner), {&light, 1});
    EXPECT_EQ(readMask(masks, 0), std::vector<std::uint8_t>(hostWidth * hostHeight, 255));
}

TEST(ShadowMasks, OfWhatOnlyReceivesShowNoShadowOfIt) {
    const gl::HeadlessContext context({hostWidth, hostHeight});
    ShadowMasks masks(eglLookUp);
    const Scene scene = yard().scene();
    MaskMesh mesh = meshOf(geometryOf(scene));
    mesh.casts = false;
    masks.add(mesh);
    const MaskLight light = hostLight(sun({0.5, 1, -0.3}));
    masks.draw(viewOf(corner), {&light, 1});
    EXPECT_EQ(shadowed(readMask(masks, 0)), 0u);
}

TEST(ShadowMasks, RefuseWhatIsWrongInASentence) {
    const gl::HeadlessContext context({hostWidth, hostHeight});
    ShadowMasks masks(eglLookUp);
    const std::vector<float> positions = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const std::vector<std::uint32_t> beyond = {0, 1, 3}, two = {0, 1};
    EXPECT_THROW(masks.add({positions, beyond}), std::runtime_error);
    EXPECT_THROW(masks.add({positions, two}), std::runtime_error);
    EXPECT_THROW(masks.remove(0), std::runtime_error);
    EXPECT_THROW(masks.move(7, identity16), std::runtime_error);
    MaskLight spot;
    spot.kind = MaskLight::Kind::spot;
    spot.outerAngle = 0.0;
    EXPECT_THROW(masks.draw(viewOf(corner), {&spot, 1}), std::runtime_error);
    const std::vector<MaskLight> many(ShadowMasks::mostLights + 1);
    EXPECT_THROW(masks.draw(viewOf(corner), many), std::runtime_error);
}

} // namespace edgeshade
