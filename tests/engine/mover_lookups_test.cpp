// Casters that move over a lookup of those at rest: the lookup is kept, their own volumes are
// counted on top, and both together show the shadows of `render --mask`.
#include "tests/engine/host_picture.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <stdexcept>

namespace edgeshade {
namespace {

using namespace test;

const Camera corner{{5, 4, 6}, {0, 0.5, 0}, 50.0};

/// Adds a limb: a closed prism with a square at either end.
void addLimb(SceneBuilder& to, const glm::vec3& top, const glm::vec3& foot) {
    const auto at = [&](int i) {
        const float x = i == 0 || i == 3 ? -0.12f : 0.12f, z = i < 2 ? -0.12f : 0.12f;
        return glm::vec3(x, 0, z);
    };
    to.quad(top + at(3), top + at(2), top + at(1), top + at(0));
    to.quad(foot + at(0), foot + at(1), foot + at(2), foot + at(3));
    for (int i = 0; i < 4; ++i) {
        const glm::vec3 a = at(i), b = at((i + 1) % 4);
        to.quad(foot + a, top + a, top + b, foot + b);
    }
}

/// A figure with swinging legs and arms, whose shape differs at each step.
Scene figure(int step) {
    const float swing = 0.3f * std::sin(0.9f * static_cast<float>(step));
    SceneBuilder built;
    built.box({-0.3f, 0.9f, -0.18f}, {0.3f, 1.7f, 0.18f});
    built.box({-0.15f, 1.72f, -0.15f}, {0.15f, 2.0f, 0.15f});
    addLimb(built, {-0.15f, 0.88f, 0.0f}, {-0.15f, 0.02f, swing});
    addLimb(built, {0.15f, 0.88f, 0.0f}, {0.15f, 0.02f, -swing});
    addLimb(built, {-0.45f, 1.65f, 0.0f}, {-0.45f, 0.9f, -swing});
    addLimb(built, {0.45f, 1.65f, 0.0f}, {0.45f, 0.9f, swing});
    return built.scene();
}

glm::dmat4 placeAt(int step) {
    return glm::translate(glm::dmat4(1.0), {-2.0 + 0.55 * step, 0.01, 1.63 - 0.35 * step});
}

Scene yardWithFigure(int step) {
    Scene scene = yard().scene();
    scene.batches.push_back(figure(step).batches.front());
    scene.batches.back().worldFromBatch = placeAt(step);
    return scene;
}

/// A yard through which a figure walks.
struct Walk {
    const gl::HeadlessContext& context;
    Scene still = yard().scene(), bent = figure(0);
    int step = 0;
    ShadowMasks masks{eglLookUp};
    ShadowMasks::Id ground, walker;

    explicit Walk(const gl::HeadlessContext& of) : context(of) {
        ground = masks.add(meshOf(geometryOf(still)));
        walker = masks.add(bentMesh(), numbersOf(placeAt(0)));
    }

    MaskMesh bentMesh() const {
        MaskMesh mesh = meshOf(geometryOf(bent));
        mesh.bends = true;
        return mesh;
    }
    void walkTo(int next) {
        step = next;
        bent = figure(step);
        masks.change(walker, bentMesh());
        masks.move(walker, numbersOf(placeAt(step)));
    }
    /// The host's picture, by the lookup and the mask of its movers.
    Mask picture(ShadowMasks::LookupId id, const MaskLight& light, bool nearness) {
        MaskView view = viewOf(corner);
        view.nearness = nearness; // its depth is the mask's, then
        if (nearness)
            for (int steps = 0; !masks.planAhead(view, {&light, 1}, {&id, 1}); ++steps)
                if (steps == 8) throw std::runtime_error("Planning ahead has no end.");
        masks.draw(view, {&light, 1}, {&id, 1});
        Mask moved = readMask(masks, 0);
        if (nearness) { // where no surface is, the mask says nothing
            const std::vector<std::uint8_t> near = readTexture(masks.nearness().texture);
            for (std::size_t i = 0; i < moved.size(); ++i) {
                const std::size_t x = i % hostWidth, y = hostHeight - 1 - i / hostWidth;
                const std::uint8_t* rgb = &near[4 * (y * hostWidth + x)];
                if (rgb[0] + rgb[1] + rgb[2] == 0) moved[i] = 255;
            }
        }
        HostPicture shader(masks, id, light, viewOf(corner), {});
        shader.draw(geometryOf(still), identity16, true);
        shader.draw(geometryOf(bent), numbersOf(placeAt(step)), true);
        Mask both = redOf(context);
        for (std::size_t i = 0; i < both.size(); ++i)
            both[i] = std::min(both[i], moved[i]);
        return both;
    }
};

const std::vector<Light>& lights() {
    static const std::vector<Light> all = {sun({0.5, 1, -0.3}), pointLight({0.3, 4, 0.7}), spot(),
                                           pointLight({-0.4, 1.1, 0.9})};
    return all;
}

} // namespace

TEST(MoverLookups, ShowWhatRenderDrawsWhileAFigureWalks) {
    constexpr int steps = 7;
    std::vector<std::vector<Mask>> expected(lights().size());
    for (std::size_t i = 0; i < lights().size(); ++i)
        for (int step = 0; step < steps; ++step)
            expected[i].push_back(renderedMask(yardWithFigure(step), corner, lights()[i]));
    const gl::HeadlessContext context({hostWidth, hostHeight});
    Walk walk(context);
    walk.walkTo(1); // only now it is a mover
    std::vector<ShadowMasks::LookupId> ids;
    for (const Light& of : lights())
        ids.push_back(lookedUp(walk.masks, hostLight(of), {.restMs = 1e9}));
    std::size_t kept = 0, compares = 0;
    // It walks, rests at step 4, and starts again.
    for (const int step : {0, 1, 2, 3, 4, 4, 4, 5, 6}) {
        walk.walkTo(step);
        for (std::size_t i = 0; i < lights().size(); ++i) {
            const MaskLight light = hostLight(lights()[i]);
            const LookupState state = walk.masks.state(ids[i], light, 0.0);
            kept += state.holds;
            EXPECT_EQ(state.movers, 1u);
            EXPECT_EQ(state.rested, 1u) << "for no time at all";
            EXPECT_EQ(walk.masks.state(ids[i], light, 1e9).rested, 0u);
            EXPECT_FALSE(walk.masks.isCurrent(ids[i], light));
            const Mask& wanted = expected[i][static_cast<std::size_t>(step)];
            const Wrong wrong = compared(walk.picture(ids[i], light, step % 2 == 0), wanted);
            EXPECT_EQ(wrong.beyond, 0u) << "light " << i << ", step " << step;
            EXPECT_LE(wrong.all, 20u) << "light " << i << ", step " << step;
            ++compares;
        }
    }
    EXPECT_EQ(kept, compares) << "the lookup is kept in every frame";
}

TEST(MoverLookups, CountOnlyTheMoversVolumes) {
    const gl::HeadlessContext context({hostWidth, hostHeight});
    Walk walk(context);
    const MaskLight light = hostLight(lights()[0]);
    walk.walkTo(1);
    const auto id = lookedUp(walk.masks, light, {.restMs = 1e9});
    walk.masks.draw(viewOf(corner), {&light, 1});
    const std::size_t all = walk.masks.cost().vertexRuns;
    walk.masks.draw(viewOf(corner), {&light, 1}, {&id, 1});
    const std::size_t moving = walk.masks.cost().vertexRuns;
    walk.masks.remove(walk.walker);
    EXPECT_TRUE(walk.masks.isCurrent(id, light)) << "the lookup holds all that is left";
    walk.masks.draw(viewOf(corner), {&light, 1}, {&id, 1});
    EXPECT_EQ(walk.masks.cost().vertexRuns, 0u);
    EXPECT_EQ(readMask(walk.masks, 0), Mask(std::size_t{hostWidth} * hostHeight, 255));
    walk.masks.draw(viewOf(corner), {&light, 1});
    EXPECT_EQ(moving + walk.masks.cost().vertexRuns, all);
}

TEST(MoverLookups, StayRightWhenCastersAreMerged) {
    const gl::HeadlessContext context({hostWidth, hostHeight});
    ShadowMasks masks(eglLookUp);
    const MaskView view = viewOf(corner);
    const MaskLight light = hostLight(lights()[0]);
    const Scene still = yard().scene();
    const Scene box = SceneBuilder().box({-0.1f, 0.0f, -0.1f}, {0.1f, 0.3f, 0.1f}).scene();
    const auto placeOf = [](int i, double lift) {
        return numbersOf(glm::translate(glm::dmat4(1.0),
                                        {-3.0 + 0.7 * (i % 8), 1.2 + lift, -2.5 + 0.8 * (i / 8)}));
    };
    masks.add(meshOf(geometryOf(still)));
    const PreparedMesh prepared(meshOf(geometryOf(box)));
    std::vector<Matrix16> places;
    std::vector<ShadowMasks::Id> boxes;
    const auto addBox = [&] {
        places.push_back(placeOf(static_cast<int>(places.size()), 0.0));
        boxes.push_back(masks.add(prepared, places.back()));
    };
    const auto rest = [&] {
        for (int i = 0; i < 40; ++i)
            masks.draw(view, {&light, 1});
    };
    while (places.size() < 16)
        addBox();
    rest();
    const std::size_t merged = masks.cost().batches;
    EXPECT_LT(merged, 16u);
    const auto id = lookedUp(masks, light);
    const auto isRight = [&](std::size_t movers) {
        masks.draw(view, {&light, 1});
        const Mask wanted = readMask(masks, 0);
        EXPECT_EQ(masks.state(id, light).movers, movers);
        masks.draw(view, {&light, 1}, {&id, 1});
        Mask both = readMask(masks, 0);
        HostPicture picture(masks, id, light, view, {});
        picture.draw(geometryOf(still), identity16, true);
        for (const Matrix16& place : places)
            picture.draw(geometryOf(box), place, true);
        const Mask looked = redOf(context);
        for (std::size_t i = 0; i < both.size(); ++i)
            both[i] = std::min(both[i], looked[i]);
        EXPECT_EQ(compared(both, wanted).beyond, 0u) << movers << " movers";
    };
    isRight(0);
    while (places.size() < 20)
        addBox(); // after the map
    isRight(4);
    rest();
    masks.draw(view, {&light, 1}, {&id, 1});
    EXPECT_LE(masks.cost().batches, merged + 1) << "they are merged, too";
    isRight(4);
    masks.move(boxes.back(), places.back() = placeOf(19, 0.4)); // splits them again
    isRight(4);
}

TEST(MoverLookups, EndOnceACasterAtRestStarts) {
    const gl::HeadlessContext context({hostWidth, hostHeight});
    Walk walk(context);
    ShadowMasks& masks = walk.masks;
    const MaskLight light = hostLight(lights()[0]);
    const Scene box = SceneBuilder().box({-1, 2, -1}, {1, 2.5f, 1}).scene();
    const auto lid = masks.add(meshOf(geometryOf(box)));
    walk.walkTo(1);
    std::size_t rest = masks.restingState();
    const auto restChanged = [&] { return std::exchange(rest, masks.restingState()) != rest; };
    auto id = lookedUp(masks, light);
    EXPECT_EQ(masks.state(id, light).movers, 1u) << "the walker alone has moved lately";
    walk.walkTo(2);
    EXPECT_FALSE(restChanged()) << "it moved a moment ago";
    masks.move(lid, numbersOf(glm::translate(glm::dmat4(1.0), {0.3, 0, 0})));
    EXPECT_TRUE(restChanged());
    EXPECT_FALSE(masks.state(id, light).holds);
    EXPECT_THROW(masks.draw(viewOf(corner), {&light, 1}, {&id, 1}), std::runtime_error);
    id = lookedUp(masks, light);
    EXPECT_TRUE(masks.state(id, light).holds);
    EXPECT_EQ(masks.state(id, light).movers, 2u);
    masks.remove(lid);
    EXPECT_TRUE(masks.state(id, light).holds) << "it left, but wasn't in the map";
    EXPECT_EQ(masks.state(id, light).movers, 1u);
    masks.add(meshOf(geometryOf(box)));
    EXPECT_TRUE(restChanged());
    EXPECT_EQ(masks.state(id, light).movers, 2u) << "counted until another map holds it";
    id = lookedUp(masks, light, {.restMs = 0.0});
    EXPECT_TRUE(masks.isCurrent(id, light)) << "all casters were in the map";
    masks.draw(viewOf(corner), {&light, 1}, {&id, 1});
    const auto refuses = [&](const MaskLight& of) {
        EXPECT_THROW(masks.draw(viewOf(corner), {&of, 1}, {&id, 1}), std::runtime_error);
    };
    MaskLight moved = light;
    moved.position[0] += 1.0;
    moved.direction[0] += 1.0;
    refuses(moved);
    masks.remove(walk.ground);
    refuses(light);
    EXPECT_FALSE(masks.state(id, light).holds);
}

TEST(MoverLookups, BoundTheLayersOfTheMoversThatEachLeavesOut) {
    SceneBuilder stack;
    for (int i = 0; i < 256; ++i) // one more than a stencil counts
        stack.floor(0.8f, 1.0f + 0.002f * static_cast<float>(i));
    const Scene ground = yard().scene(), sheets = stack.scene();
    const gl::HeadlessContext context({hostWidth, hostHeight});
    const MaskLight light = hostLight(sun({0.01, 1, 0.02}));
    std::vector<Mask> drawn;
    for (const bool alone : {true, false}) {
        ShadowMasks masks(eglLookUp);
        masks.add(meshOf(geometryOf(ground)));
        const auto id = masks.add(meshOf(geometryOf(sheets)));
        masks.move(id, numbersOf(glm::translate(glm::dmat4(1.0), {0.2, 0, 0})));
        const auto resting = lookedUp(masks, light, {.restMs = 1e9});
        const auto all = lookedUp(masks, light, {.restMs = 0.0});
        if (!alone) masks.draw(viewOf(corner), {&light, 1}, {&all, 1}); // without movers
        masks.draw(viewOf(corner), {&light, 1}, {&resting, 1});
        drawn.push_back(readMask(masks, 0));
    }
    EXPECT_GT(std::count(drawn[0].begin(), drawn[0].end(), 0), 500);
    EXPECT_EQ(drawn[0], drawn[1]);
}

TEST(MoverLookups, RefuseInASentence) {
    const gl::HeadlessContext context({hostWidth, hostHeight});
    Walk walk(context);
    const MaskLight light = hostLight(lights()[0]);
    const auto id = lookedUp(walk.masks, light);
    const std::array<ShadowMasks::LookupId, 2> two = {id, id};
    EXPECT_THROW(walk.masks.draw(viewOf(corner), {&light, 1}, two), std::runtime_error);
    EXPECT_THROW(walk.masks.lookupWork(light, {.restMs = -1.0}), std::runtime_error);
    EXPECT_THROW(walk.masks.lookupWork(light, {.restMs = std::nan("")}), std::runtime_error);
    LookupWork work = walk.masks.lookupWork(light);
    work.finish();
    const auto waiting = walk.masks.addLookup(work);
    EXPECT_THROW(walk.masks.draw(viewOf(corner), {&light, 1}, {&waiting, 1}), std::runtime_error)
        << "it isn't uploaded";
    const auto none = ShadowMasks::noLookup;
    walk.masks.draw(viewOf(corner), {&light, 1}, {&none, 1});
    walk.walkTo(1);
    walk.masks.remove(walk.ground);
    EXPECT_EQ(walk.masks.lookup(lookedUp(walk.masks, light, {.restMs = 1e9})).why,
              "all casters move");
}

} // namespace edgeshade
