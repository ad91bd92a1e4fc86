// Lights without a shadow are added up in one pass, tile by tile, with the same result as one pass
// each; lights that reach nothing visible cost nothing.
#include "src/bench/scattered_lights.hpp"
#include "src/gl/headless_context.hpp"
#include "src/render/frame/prepare_scene.hpp"
#include "src/shadow/view/light_budget.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/scene_builder.hpp"

#include <cstdlib>
#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::SceneBuilder;
using test::TestView;

constexpr int width = 120, height = 90;
const Camera camera{{0, 5, 9}, {0, 0, 0}, 45.0};

bool canList() {
    const gl::HeadlessContext context(test::testPicture(4, 4));
    return LightTable::isPossible(context.capabilities());
}

RenderSettings settingsOf(Shading shading, ShadowMethod shadows) {
    RenderSettings settings;
    settings.shading = shading;
    settings.shadows = shadows;
    settings.ambient = 0.2f;
    return settings;
}

int largestDifference(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    int most = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        most = std::max(most, std::abs(int{a[i]} - int{b[i]}));
    return most;
}

/// One of each kind: with and without candela, ranges and cones, and suns.
std::vector<Light> lightsOfAllKinds() {
    std::vector<Light> lights;
    const auto add = [&](const Light& light, const glm::vec3& color, bool photometric) {
        lights.push_back(light);
        lights.back().color = color;
        lights.back().photometric = photometric;
    };
    Light ranged = test::pointLight({-2, 1, 1});
    ranged.range = 3.0;
    Light spot = test::pointLight({2, 4, 2});
    spot.cone = Cone{glm::normalize(glm::dvec3(-0.5, -1, -0.3)), 0.2, 0.5};
    Light both = spot;
    both.position = {-3, 3, -2, 1};
    both.range = 6.0;
    both.cone = Cone{glm::normalize(glm::dvec3(0.4, -1, 0.3)), 0.4, 0.4};
    add(test::sun({0.3, 1, 0.2}), {0.3f, 0.2f, 0.1f}, false);
    add(ranged, {1.0f, 0.4f, 0.3f}, false);
    add(spot, {0.2f, 9.0f, 0.3f}, true);
    add(both, {1.0f, 1.0f, 4.0f}, false);
    add(test::pointLight({3, 2, -3}), {0.7f, 3.0f, 3.0f}, true);
    add(test::sun({-1, 0.5, 0.5}), {0.1f, 0.1f, 0.3f}, true);
    both.position = {1, 2, 0, 1};
    add(both, {5.0f, 0.1f, 1.0f}, true);
    return lights;
}

/// Boxes and a sheet over a floor, of materials that scatter, mirror, emit light, and are
/// see-through.
Scene furnished() {
    Material metal, glowing, glass;
    metal.metallic = 1.0f;
    metal.roughness = 0.3f;
    metal.baseColorFactor = {0.9f, 0.8f, 0.4f, 1.0f};
    glowing.emissive = {0.2f, 0.1f, 0.3f};
    glass.alphaMode = AlphaMode::blend;
    glass.baseColorFactor = {0.3f, 0.5f, 0.9f, 0.4f};
    glass.doubleSided = true;
    Material plain;
    plain.unlit = true;
    plain.baseColorFactor = {0.2f, 0.6f, 0.3f, 1.0f};
    return SceneBuilder()
        .floor(5)
        .box({-2, 0, -2}, {-1, 2, -1})
        .material(metal)
        .box({1, 0, -1}, {2, 1, 0})
        .material(glowing)
        .box({-1, 0, 1}, {0, 1, 2})
        .material(plain)
        .box({2, 0, 2}, {3, 1, 3})
        .material(glass)
        .quad({-3, 0, 2.5}, {0, 0, 2.5}, {0, 2, 2.5}, {-3, 2, 2.5})
        .scene();
}

TEST(ManyLights, OnePassLeavesWhatAPassEachLeaves) {
    const Scene scene = furnished();
    const TestView view{camera, lightsOfAllKinds(), width, height};
    for (const Shading shading : {Shading::full, Shading::base}) {
        const auto apart = test::drawScene(scene, view, settingsOf(shading, ShadowMethod::none));
        RenderSettings settings = settingsOf(shading, ShadowMethod::volumes);
        settings.shadowedLights = 0;
        const auto listed = test::drawScene(scene, view, settings);
        // Each pass rounds, if the sum is kept in half floats or bytes.
        EXPECT_LE(largestDifference(apart, listed), shading == Shading::full ? 2 : 4);
        RenderSettings dark = settingsOf(shading, ShadowMethod::none);
        TestView none = view;
        none.drawnLights.emplace();
        EXPECT_GT(largestDifference(apart, test::drawScene(scene, none, dark)), 50);
    }
}

TEST(ManyLights, SomeHaveShadowsAndTheOthersShineThrough) {
    const Scene scene = SceneBuilder().floor(5).box({-1, 1, -1}, {1, 2, 1}).scene();
    std::vector<Light> lights;
    for (const double x : {-3.0, -1.0, 1.0, 3.0}) {
        lights.push_back(test::pointLight({x, 4, 0}));
        lights.back().photometric = true;
        lights.back().color = glm::vec3(static_cast<float>(8.0 + x));
    }
    const TestView view{camera, lights, width, height};
    RenderSettings settings = settingsOf(Shading::full, ShadowMethod::volumes);
    settings.shadowedLights = 4;
    const auto all = test::drawScene(scene, view, settings);
    settings.shadowedLights.reset();
    EXPECT_EQ(test::drawScene(scene, view, settings), all);
    // Only the brightest: as if the others had been added without shadows.
    settings.shadowedLights = 1;
    const auto one = test::drawScene(scene, view, settings);
    const auto none = test::drawScene(scene, view, settingsOf(Shading::full, ShadowMethod::none));
    std::size_t darker = 0, darkest = 0;
    for (std::size_t i = 0; i < one.size(); i += 4) {
        ASSERT_LE(one[i], none[i] + 2) << i / 4;
        ASSERT_LE(all[i], one[i] + 2) << i / 4;
        darker += one[i] + 5 < none[i];
        darkest += all[i] + 5 < one[i];
    }
    EXPECT_GT(darker, 100u);
    EXPECT_GT(darkest, 100u);
}

/// The work of a frame for these lights.
struct Work {
    std::size_t reaching = 0, counted = 0, listed = 0, draws = 0, vertexRuns = 0, bytes = 0,
                lists = 0;

    bool operator==(const Work&) const = default;
};

Work workFor(const Scene& scene, const std::vector<Light>& lights, const RenderSettings& settings) {
    const gl::HeadlessContext context(test::testPicture(width, height));
    RenderSettings drawn = settings;
    drawn.layout = bestLayout(context.capabilities());
    const LoadedScene loaded{{}, scene, {}, buildPlanePairs(scene, false), {}, {}};
    FrameView view =
        makeFrameView(scene, {frustumOf(camera, double(width) / height), width, height, lights},
                      worldBounds(scene));
    chooseLights(view, drawn.shadowedLights);
    GpuScene gpu = uploadScene(loaded, drawn.records(), context.capabilities());
    Renderer renderer(drawn, context.capabilities());
    prepareScene(gpu, loaded, view, renderer);
    renderer.draw(gpu, view);
    gl::requireNoError("drawing many lights");
    Work work;
    for (const SlicePlan& slice : renderer.plan().slices) {
        for (const LightPlan& light : slice.lights) {
            work.reaching += !light.reach.empty();
            work.counted += light.isCounted();
            work.listed += light.listed;
            for (const CountPlan& count : light.counts)
                work.draws += count.draws.twice.size() + count.draws.once.size();
        }
        if (slice.lists) work.lists += slice.lists->lights.size();
    }
    work.vertexRuns = renderer.vertexRuns();
    work.bytes = renderer.volumes() ? renderer.volumes()->bytes() : 0;
    return work;
}

TEST(ManyLights, ThoseThatReachNothingCostNothing) {
    const Scene scene = test::yard().scene();
    const std::vector<Light> some = bench::scatterLights(scene, 9);
    std::vector<Light> more = some;
    for (int i = 0; i < 500; ++i) {
        Light away = some[static_cast<std::size_t>(i) % some.size()];
        const double angle = 0.7 * i;
        away.position += glm::dvec4(40.0 * std::cos(angle), i % 3 - 1.0, 40.0 * std::sin(angle), 0);
        more.push_back(away);
        away.position = some[0].position + glm::dvec4(0.0, 30.0 + i, 0.0, 0.0);
        if (more.size() < mostLights) more.push_back(away);
    }
    more.resize(std::min(more.size(), mostLights));
    RenderSettings settings = settingsOf(Shading::full, ShadowMethod::volumes);
    const Work few = workFor(scene, some, settings);
    EXPECT_GT(few.reaching, 5u);
    EXPECT_EQ(few.counted, few.reaching);
    EXPECT_GT(few.draws, few.reaching);
    EXPECT_GT(few.bytes, 0u);
    EXPECT_EQ(workFor(scene, more, settings), few);
    settings.shadowedLights = 3;
    const Work budget = workFor(scene, more, settings);
    EXPECT_EQ(budget, workFor(scene, some, settings));
    EXPECT_EQ(budget.counted, 3u);
    EXPECT_EQ(budget.reaching, few.reaching);
    EXPECT_LT(budget.draws, few.draws);
    EXPECT_EQ(budget.listed, canList() ? budget.reaching - 3 : 0);
    EXPECT_EQ(budget.lists, budget.listed);
}

TEST(ManyLights, WorkGrowsNoFasterThanLights) {
    // The more lights there are, the fewer casters each reaches: each has its own rectangle.
    SceneBuilder builder;
    builder.floor(10);
    for (float x = -9.0f; x < 9.0f; x += 1.0f)
        for (float z = -9.0f; z < 9.0f; z += 1.0f)
            builder.box({x + 0.3f, 0.0f, z + 0.3f}, {x + 0.7f, 0.5f, z + 0.7f});
    const Scene scene = builder.scene();
    const RenderSettings settings = settingsOf(Shading::full, ShadowMethod::volumes);
    Work before;
    for (const std::size_t lights : {4u, 16u, 64u}) {
        const Work work = workFor(scene, bench::scatterLights(scene, lights), settings);
        EXPECT_GT(work.counted, lights / 3);
        EXPECT_LE(work.vertexRuns * before.counted, before.vertexRuns * work.counted)
            << lights << " lights";
        before = work;
    }
}

TEST(ScatteredLights, AreTheSameAndOverlapAlike) {
    const Scene scene = test::yard().scene();
    for (const std::size_t count : {16u, 250u, 1000u}) {
        const std::vector<Light> lights = bench::scatterLights(scene, count);
        ASSERT_EQ(lights.size(), count);
        EXPECT_EQ(lights, bench::scatterLights(scene, count));
        std::size_t reaching = 0, places = 0;
        for (double x = -3.9; x < 4.0; x += 0.2)
            for (double z = -3.9; z < 4.0; z += 0.2, ++places)
                for (const Light& light : lights)
                    reaching += glm::distance(glm::dvec3(light.position), {x, 0, z}) < light.range;
        const double overlap = static_cast<double>(reaching) / static_cast<double>(places);
        EXPECT_GT(overlap, 0.5 * bench::overlappingLights) << count;
        EXPECT_LT(overlap, 1.5 * bench::overlappingLights) << count;
    }
}

} // namespace
} // namespace edgeshade
