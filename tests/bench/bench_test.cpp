// Tests of bench: they judge its pictures and counts, never the times themselves.

#include "src/bench/bench.hpp"
#include "src/bench/flythrough.hpp"
#include "src/gl/headless_context.hpp"
#include "src/rivals/rivals.hpp"
#include "tests/support/bounded_frame.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/scene_builder.hpp"

#include <gtest/gtest.h>

namespace edgeshade::bench {
namespace {

using test::pointLight;

LoadedScene yard() {
    const Scene scene = test::yard().scene();
    return {{}, scene, {}, buildPlanePairs(scene, false), {}, {}};
}

Setting settingOf(ShadowMethod shadows) {
    Setting setting;
    setting.name = shadows == ShadowMethod::volumes ? "volumes"
                   : shadows == ShadowMethod::map   ? "map"
                                                    : "none";
    setting.render.shadows = shadows;
    setting.render.map.size = 64;
    return setting;
}

Task taskFor(const LoadedScene& loaded) {
    Task task;
    task.width = task.height = 32;
    task.frames = 6;
    task.warmUp = 1;
    task.frustumAt = [flight = Flythrough(worldBounds(loaded.scene), 45.0, 1.0)](double share) {
        return frustumOf(flight.cameraAt(share), 1.0);
    };
    task.lights = {pointLight({2.0, 6.0, 3.0})};
    for (const ShadowMethod shadows :
         {ShadowMethod::volumes, ShadowMethod::map, ShadowMethod::none})
        task.settings.push_back(settingOf(shadows));
    return task;
}

void ignore(double) {}

TEST(Bench, EverySettingHasATimeForEveryFrame) {
    const LoadedScene loaded = yard();
    double last = -1.0;
    const Report report = measure(loaded, taskFor(loaded), [&](double share) {
        EXPECT_GE(share, last);
        last = share;
    });
    EXPECT_EQ(last, 1.0);
    ASSERT_EQ(report.results.size(), 3u);
    EXPECT_EQ(report.results[0].name, "volumes");
    for (const Result& result : report.results) {
        EXPECT_EQ(result.frameMs.size(), 6u);
        for (const double ms : result.frameMs)
            EXPECT_GT(ms, 0.0);
        EXPECT_GT(result.stageMs.ambient, 0.0);
        EXPECT_EQ(result.stageMs.lit > 0.0, result.name == "volumes") << result.name;
        EXPECT_GT(result.repeated, 0.0);
    }
}

TEST(Bench, OnlyVolumesHaveRecordsAndOnlyMapsHaveMaps) {
    const LoadedScene loaded = yard();
    Task task = taskFor(loaded);
    task.settings.push_back(settingOf(ShadowMethod::volumes));
    task.settings.back().render.multiplicity = MultiplicityMethod::referenceEdge;
    task.settings.back().render.rivals = &allRivals();
    const Report report = measure(loaded, task, ignore);
    const Result &planePairs = report.results[0], &map = report.results[1],
                 &none = report.results[2], &volumes = report.results[3];
    const BatchShadow shadow = *buildShadows(loaded.scene, false).front();
    const auto side = static_cast<std::size_t>(shadow.sides.maxMultiplicity) * 6;
    EXPECT_EQ(volumes.vertexRuns %
                  (shadow.sides.recordCount() * side + shadow.caps.recordCount() * 6),
              0u)
        << "as many times as there are depth slices";
    EXPECT_GT(planePairs.vertexRuns, 0u);
    EXPECT_LT(planePairs.vertexRuns, volumes.vertexRuns);
    EXPECT_GT(planePairs.sideBytes, 0u);
    EXPECT_LT(planePairs.sideBytes, volumes.sideBytes);
    EXPECT_GT(volumes.sideBytes, 0u);
    EXPECT_EQ(volumes.mapBytes, 0u);
    EXPECT_GT(volumes.stageMs.silhouette, 0.0);
    EXPECT_EQ(map.sideBytes + map.capBytes, 0u);
    EXPECT_GE(map.mapBytes, 6u * 64 * 64 * 4);
    EXPECT_EQ(map.stageMs.silhouette + map.stageMs.rasterise, 0.0);
    EXPECT_EQ(none.bytes(), 0u);
    EXPECT_EQ(none.vertexRuns, 0u);
}

TEST(Bench, NobodyIsChargedForWhatOthersHaveOnTheGpu) {
    const LoadedScene loaded = yard();
    Task task = taskFor(loaded);
    task.settings = {settingOf(ShadowMethod::volumes)};
    const Result alone = measure(loaded, task, ignore).results[0];
    task.settings.push_back(settingOf(ShadowMethod::volumes));
    task.settings.back().render.silhouette = SilhouetteChoice::all;
    const Report report = measure(loaded, task, ignore);
    EXPECT_EQ(report.results[0].bytes(), alone.bytes());
    EXPECT_NE(report.results[1].bytes(), alone.bytes());
}

TEST(Bench, AMapIsKeptWhileTheLightRestsAndDrawnWhileItMoves) {
    const LoadedScene loaded = yard();
    Task task = taskFor(loaded);
    EXPECT_EQ(measure(loaded, task, ignore).results[1].vertexRuns, 0u);
    task.lightMoves = true;
    const Report moving = measure(loaded, task, ignore);
    EXPECT_GT(moving.results[1].vertexRuns, 0u);
    EXPECT_GT(moving.results[1].stageMs.map, 0.0);
}

/// Records the stages and does nothing else.
class StageList : public StageClock {
  public:
    explicit StageList(bool silhouette) : silhouette_(silhouette) {}
    void enter(FrameStage stage) override {
        EXPECT_FALSE(inside_);
        inside_ = true;
        stages.push_back(stage);
    }
    void leave() override { inside_ = false; }
    bool wantsSilhouette() const override { return silhouette_; }

    std::vector<FrameStage> stages;

  private:
    bool silhouette_;
    bool inside_ = false;
};

/// The yard's picture, with or without a clock.
std::vector<std::uint8_t> pictureOf(ShadowMethod shadows, StageClock* clock) {
    const LoadedScene loaded = yard();
    const gl::HeadlessContext context({64, 64});
    RenderSettings settings = settingOf(shadows).render;
    settings.layout = bestLayout(context.capabilities());
    Renderer renderer(settings, context.capabilities());
    GpuScene scene = uploadScene(loaded, settings.records(), context.capabilities());
    FrameRequest request;
    request.frustum = frustumOf({{6.0, 5.0, 7.0}, {0.0, 0.0, 0.0}, 45.0}, 1.0);
    request.width = request.height = 64;
    request.lights = {pointLight({2.0, 6.0, 3.0})};
    request.depth.slices = 1;
    renderer.draw(scene, test::boundedFrame(loaded.scene, loaded.settings.castMasked, request),
                  clock);
    return context.readPixels();
}

TEST(StageClock, IsToldTheStagesInTheirOrder) {
    StageList volumes(true), plain(false), map(true), none(true);
    pictureOf(ShadowMethod::volumes, &volumes);
    // The volumes of the first light are planned before the stencil is cleared.
    EXPECT_EQ(volumes.stages,
              (std::vector{FrameStage::silhouette, FrameStage::counting, FrameStage::ambient,
                           FrameStage::counting, FrameStage::lit}));
    pictureOf(ShadowMethod::volumes, &plain);
    EXPECT_EQ(plain.stages, (std::vector{FrameStage::counting, FrameStage::ambient,
                                         FrameStage::counting, FrameStage::lit}));
    pictureOf(ShadowMethod::map, &map);
    EXPECT_EQ(map.stages, (std::vector{FrameStage::map, FrameStage::ambient}));
    pictureOf(ShadowMethod::none, &none);
    EXPECT_EQ(none.stages, (std::vector{FrameStage::ambient}));
}

TEST(StageClock, ChangesNoPicture) {
    for (const ShadowMethod shadows : {ShadowMethod::volumes, ShadowMethod::map}) {
        StageList clock(true);
        EXPECT_EQ(pictureOf(shadows, &clock), pictureOf(shadows, nullptr));
    }
}

TEST(StageTimes, TheSilhouetteIsTakenOffTheVolumes) {
    const auto span = [](FrameStage stage, double ms) {
        return gl::SpanTimer::Span{static_cast<int>(stage), ms, false};
    };
    const std::vector<gl::SpanTimer::Span> spans = {
        span(FrameStage::ambient, 1.0),    span(FrameStage::silhouette, 2.0),
        span(FrameStage::counting, 7.0),   span(FrameStage::lit, 3.0),
        span(FrameStage::silhouette, 1.0), span(FrameStage::counting, 4.0),
        span(FrameStage::lit, 0.5)};
    const StageMs sum = stageMs(spans);
    EXPECT_EQ(sum.ambient, 1.0);
    EXPECT_EQ(sum.silhouette, 3.0);
    EXPECT_EQ(sum.rasterise, 8.0);
    EXPECT_EQ(sum.lit, 3.5);
    EXPECT_EQ(sum.map, 0.0);
}

TEST(SpanTimer, GivesEverySpanOnceInItsOrder) {
    const gl::HeadlessContext context({16, 16});
    std::vector<gl::Timing> timings = {gl::Timing::finish, gl::Timing::processor};
    if (context.capabilities().timerQueries) timings.push_back(gl::Timing::query);
    for (const gl::Timing timing : timings) {
        gl::SpanTimer timer(timing, context.capabilities());
        for (int label = 0; label < 5; ++label) {
            timer.begin(label);
            timer.end();
        }
        const auto spans = timer.takeAll();
        ASSERT_EQ(spans.size(), 5u);
        for (int label = 0; label < 5; ++label)
            EXPECT_EQ(spans[static_cast<std::size_t>(label)].label, label);
        EXPECT_TRUE(timer.takeAll().empty());
    }
}

} // namespace
} // namespace edgeshade::bench
