// Primitive maps of many lights: together they keep to the limit, the most important lights have
// theirs, each covers its light's reach, and pictures match those of volumes.
#include "src/bench/scattered_lights.hpp"
#include "src/render/frame/prepare_scene.hpp"
#include "src/shadow/view/light_budget.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/scene_builder.hpp"

#include <cstdlib>
#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::SceneBuilder;

constexpr int width = 160, height = 120;
constexpr std::size_t megabyte = std::size_t{1} << 20;

RenderSettings settingsOf(ShadowMethod shadows, std::size_t mostBytes) {
    RenderSettings settings;
    settings.shadows = shadows;
    settings.primitiveMap.mostBytes = mostBytes;
    return settings;
}

/// Boxes in rows over a floor, 20 across.
SceneBuilder town() {
    SceneBuilder builder;
    builder.floor(10);
    for (float x = -9.0f; x < 9.0f; x += 1.0f)
        for (float z = -9.0f; z < 9.0f; z += 1.0f)
            builder.box({x + 0.3f, 0.0f, z + 0.3f}, {x + 0.7f, 0.5f, z + 0.7f});
    return builder;
}

/// A scene for drawing frames.
class Stage {
  public:
    Stage(const gl::HeadlessContext& context, const Scene& scene, RenderSettings settings)
        : context_(context), loaded_{{}, scene, {}, buildPlanePairs(scene, false), {}, {}},
          settings_(withLayout(std::move(settings))), renderer_(settings_, context_.capabilities()),
          gpu_(uploadScene(loaded_, settings_.records(), context_.capabilities())) {}

    std::vector<std::uint8_t> draw(const std::vector<Light>& lights,
                                   const Camera& camera = {{4, 14, 17}, {0, 0, 1}, 50.0}) {
        view_ = makeFrameView(loaded_.scene,
                              {frustumOf(camera, double(width) / height), width, height, lights},
                              worldBounds(loaded_.scene));
        for (FrameLight& of : view_.lights)
            of.atRest = true;
        chooseLights(view_, settings_.shadowedLights);
        prepareScene(gpu_, loaded_, view_, renderer_);
        renderer_.draw(gpu_, view_);
        gl::requireNoError("drawing maps of many lights");
        return context_.readPixels();
    }

    std::size_t mapBytes() const { return gpu_.primitiveMaps.bytes(); }
    std::size_t bytesOf(const Light& light) const {
        const PrimitiveMapState* state = gpu_.primitiveMaps.of(light);
        return state && state->map ? state->map->bytes() : 0;
    }
    std::string whyOf(const Light& light) const { return gpu_.primitiveMaps.of(light)->why; }
    std::size_t mapsOf(const std::vector<Light>& lights) const {
        return static_cast<std::size_t>(std::count_if(
            lights.begin(), lights.end(), [&](const Light& light) { return bytesOf(light) > 0; }));
    }
    const FrameView& view() const { return view_; }

  private:
    RenderSettings withLayout(RenderSettings settings) const {
        settings.layout = bestLayout(context_.capabilities());
        return settings;
    }

    const gl::HeadlessContext& context_;
    LoadedScene loaded_;
    RenderSettings settings_;
    Renderer renderer_;
    GpuScene gpu_;
    FrameView view_;
};

std::size_t differing(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        count += std::abs(int{a[i]} - int{b[i]}) > 4;
    return count;
}

class ManyMaps : public testing::Test {
  protected:
    void SetUp() override {
        if (!gl::hasFloatTables(context.capabilities())) GTEST_SKIP() << "no float textures";
    }

    gl::HeadlessContext context{test::testPicture(width, height)};
};

TEST_F(ManyMaps, SixtyFourLightsKeepToTheBudgetAndAreExact) {
    const Scene scene = town().scene();
    const std::vector<Light> lights = bench::scatterLights(scene, 64);
    Stage volumes(context, scene, settingsOf(ShadowMethod::volumes, 0));
    const auto counted = volumes.draw(lights);
    std::size_t before = 0;
    for (const std::size_t budget : {megabyte / 8, megabyte, 8 * megabyte, 128 * megabyte}) {
        Stage stage(context, scene, settingsOf(ShadowMethod::primitiveMap, budget));
        EXPECT_LE(differing(stage.draw(lights), counted), 40u) << budget;
        EXPECT_LE(stage.mapBytes(), budget);
        EXPECT_GE(stage.mapsOf(lights), before) << budget;
        before = stage.mapsOf(lights);
    }
    EXPECT_GT(before, 40u);
    Stage little(context, scene, settingsOf(ShadowMethod::primitiveMap, megabyte));
    little.draw(lights);
    EXPECT_GT(little.mapsOf(lights), 0u);
    EXPECT_LT(little.mapsOf(lights), before);
}

TEST_F(ManyMaps, ThoseThatMatterMostHaveTheirs) {
    const Scene scene = town().scene();
    std::vector<Light> lights;
    for (std::size_t i = 0; i < 12; ++i) { // side by side, the last ones brightest
        lights.push_back(test::pointLight({0.1 * static_cast<double>(i), 1.2, 0}));
        lights.back().color *= 1.0f + static_cast<float>(i);
        lights.back().range = 3.0;
    }
    Stage roomy(context, scene, settingsOf(ShadowMethod::primitiveMap, 128 * megabyte));
    roomy.draw(lights);
    ASSERT_EQ(roomy.mapsOf(lights), lights.size());
    Stage stage(context, scene, settingsOf(ShadowMethod::primitiveMap, roomy.mapBytes() / 2));
    stage.draw(lights);
    const std::size_t count = stage.mapsOf(lights);
    ASSERT_GT(count, 2u);
    ASSERT_LT(count, lights.size() - 2);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        EXPECT_EQ(stage.bytesOf(lights[i]) > 0, i >= lights.size() - count) << i;
        if (i > 0) {
            EXPECT_GT(importanceOf(stage.view(), lights[i]),
                      importanceOf(stage.view(), lights[i - 1]));
        }
        if (i < lights.size() - count) {
            EXPECT_NE(stage.whyOf(lights[i]).find("a primitive map would take more"),
                      std::string::npos)
                << stage.whyOf(lights[i]);
        }
    }
}

TEST_F(ManyMaps, WhatMattersMoreLaterTakesTheRoomOfOthers) {
    const Scene scene = town().scene();
    std::vector<Light> lights;
    for (const double x : {-8.0, -7.0, -6.0, 6.0, 7.0, 8.0}) {
        lights.push_back(test::pointLight({x, 1.2, 0}));
        lights.back().range = 3.0;
    }
    const std::vector<Light> left(lights.begin(), lights.begin() + 3),
        right(lights.begin() + 3, lights.end());
    const Camera atLeft{{-9, 2, 3}, {-7, 0, 0}, 40.0}, atRight{{9, 2, 3}, {7, 0, 0}, 40.0};
    Stage roomy(context, scene, settingsOf(ShadowMethod::primitiveMap, 128 * megabyte));
    roomy.draw(lights, atLeft);
    const std::size_t three = roomy.mapBytes();
    EXPECT_EQ(roomy.mapsOf(left), 3u);
    EXPECT_EQ(roomy.mapsOf(right), 0u) << "nobody sees them";
    roomy.draw(lights, atRight);
    EXPECT_EQ(roomy.mapsOf(lights), 6u) << "there is room for all";
    EXPECT_GT(roomy.mapBytes(), three);

    Stage narrow(context, scene, settingsOf(ShadowMethod::primitiveMap, three));
    narrow.draw(lights, atLeft);
    EXPECT_GT(narrow.mapsOf(left), 0u);
    narrow.draw(lights, atRight);
    EXPECT_GT(narrow.mapsOf(right), 0u);
    EXPECT_LE(narrow.mapBytes(), three);
    Stage volumes(context, scene, settingsOf(ShadowMethod::volumes, 0));
    EXPECT_LE(differing(narrow.draw(lights, atRight), volumes.draw(lights, atRight)), 40u);
}

TEST_F(ManyMaps, AMapIsOfWhatItsLightReaches) {
    const Scene scene = town().scene();
    Light everywhere = test::pointLight({0.05, 1.0, 0.1}), near = everywhere;
    near.range = 2.0;
    Stage stage(context, scene, settingsOf(ShadowMethod::primitiveMap, 128 * megabyte));
    stage.draw({everywhere});
    const std::size_t whole = stage.bytesOf(everywhere);
    stage.draw({near});
    EXPECT_EQ(stage.bytesOf(everywhere), 0u) << "it is another's";
    EXPECT_GT(stage.bytesOf(near), 0u);
    EXPECT_LT(stage.bytesOf(near), whole / 2);
    // Two lights in one place have a map each.
    stage.draw({near, everywhere});
    EXPECT_EQ(stage.bytesOf(everywhere), whole);
    EXPECT_LT(stage.bytesOf(near), whole / 2);
}

TEST_F(ManyMaps, WhereVolumesAreCountedOnlyWhatIsSeeThroughNeedsSome) {
    Material pane;
    pane.alphaMode = AlphaMode::blend;
    pane.doubleSided = true;
    pane.baseColorFactor.a = 0.5f;
    SceneBuilder builder = town();
    builder.material(pane).quad({-8, 0.6f, 0}, {-7, 0.6f, 0}, {-7, 1.6f, 0}, {-8, 1.6f, 0});
    const Scene scene = builder.scene();
    std::vector<Light> lights;
    for (double x = -7.5; x < 8.0; x += 3.0) {
        lights.push_back(test::pointLight({x, 1.0, 0.8}));
        lights.back().range = 2.5;
    }
    RenderSettings settings = settingsOf(ShadowMethod::volumes, 128 * megabyte);
    settings.shading = Shading::full;
    Stage volumes(context, scene, settings);
    const auto counted = volumes.draw(lights);
    EXPECT_EQ(volumes.mapsOf(lights), 1u);
    EXPECT_GT(volumes.bytesOf(lights[0]), 0u);
    // Casters aren't looked up, so nothing knows which side of them the light is on.
    settings.shadows = ShadowMethod::primitiveMap;
    Stage maps(context, scene, settings);
    EXPECT_LE(differing(maps.draw(lights), counted), 40u);
    EXPECT_EQ(maps.mapsOf(lights), lights.size());
    EXPECT_LT(volumes.bytesOf(lights[0]), maps.bytesOf(lights[0]));
}

/// Bytes of the map of a lamp over the town with a pane in a batch of its own, where casters don't
/// look up. `moves`: an animation can move the pane.
std::size_t bytesForPane(bool moves) {
    Material pane;
    pane.alphaMode = AlphaMode::blend;
    LoadedScene loaded{{}, town().scene(), {}, {}, {}, {}};
    Scene glazed = SceneBuilder()
                       .material(pane)
                       .quad({-8, 0.6f, 0}, {-7, 0.6f, 0}, {-7, 1.6f, 0}, {-8, 1.6f, 0})
                       .scene();
    Batch& batch = loaded.scene.batches.emplace_back(std::move(glazed.batches.front()));
    for (SurfaceGroup& group : batch.geometry.edit().groups)
        group.material += loaded.scene.materials.size();
    loaded.scene.materials.insert(loaded.scene.materials.end(), glazed.materials.begin(),
                                  glazed.materials.end());
    if (moves) batch.node = 0;
    loaded.planePairs = buildPlanePairs(loaded.scene, false);
    PrimitiveMapTask task{test::pointLight({0, 3, 0.8}), false, {}};
    task.settings.othersReceive = true;
    PrimitiveMapJob job(loaded, task, {});
    job.finish();
    return job.built().map.value().bytes();
}

TEST(PrimitiveMapJob, ForPanesAtRestBuildsLittle) {
    EXPECT_LT(2 * bytesForPane(false), bytesForPane(true)) << "a pane that moves may go anywhere";
}

} // namespace
} // namespace edgeshade
