#include "src/bench/bench.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/base/stopwatch.hpp"
#include "src/gl/headless_context.hpp"
#include "src/render/accumulation/extended_lights.hpp"
#include "src/render/frame/light_methods.hpp"
#include "src/render/frame/prepare_scene.hpp"
#include "src/scene/scene_facts.hpp"
#include "src/shadow/plan/volume_fill.hpp"
#include "src/shadow/view/kept_layers.hpp"
#include "src/shadow/view/light_budget.hpp"

#include <algorithm>
#include <map>

namespace edgeshade::bench {
namespace {

constexpr int framesPerStageFrame = 4; // stages need additional frames, so only every fourth frame
                                       // has them
constexpr int repeatedFrames = 3;      // the first frames, drawn again at the end
constexpr int mostTries = 5;           // if the GPU was disturbed

} // namespace

/// The data that a contender needs on the GPU. Only contenders with equal needs share it, as each
/// one's memory is reported.
struct Needs {
    std::optional<VolumeRecords> volumes; ///< null: draws none
    bool proposed = false; ///< only potential silhouettes; most records never reach the GPU
    bool primitiveMaps = false;
    bool automatic = false;         ///< only for lights where they pay
    bool seeThroughLooksUp = false; ///< see-through surfaces use maps where volumes are counted
    std::size_t mapBytes = 0;       ///< limit for primitive maps, if there may be any
    std::optional<std::size_t> shadowed{}; ///< lights with shadows; null: all

    auto operator<=>(const Needs&) const = default;
};

namespace {

Needs needsOf(const RenderSettings& settings) {
    Needs needs{.volumes = settings.records(),
                .proposed = settings.silhouette == SilhouetteChoice::proposed,
                .primitiveMaps = settings.looksUpPrimitives(),
                .automatic = settings.shadows == ShadowMethod::automatic};
    needs.seeThroughLooksUp =
        settings.shadows == ShadowMethod::volumes && settings.shading == Shading::full;
    if (needs.primitiveMaps || needs.seeThroughLooksUp)
        needs.mapBytes = settings.primitiveMap.mostBytes;
    if (needs.volumes) needs.shadowed = settings.shadowedLights;
    return needs;
}

} // namespace

/// A scene with the data that its contenders share.
class Stage {
  public:
    Stage(const LoadedScene& loaded, const gl::Capabilities& capabilities)
        : loaded_(loaded), capabilities_(capabilities), bounds_(worldBounds(loaded.scene)),
          tree_(loaded.scene) {}

    bool isOf(const LoadedScene& loaded) const { return &loaded == &loaded_; }

    /// Computes the frame's view. RayCrossings are kept while the lights rest. `volumes`: some
    /// contender draws volumes. `mostShadowed`: the largest number of shadowed lights of any
    /// contender.
    void look(const FrameRequest& request, bool moves, bool volumes,
              std::optional<std::size_t> mostShadowed) {
        Stopwatch watch;
        makeFrameView(loaded_.scene, request, bounds_, tree_, view_);
        chooseLights(view_, mostShadowed);
        for (FrameLight& of : view_.lights)
            of.atRest = !moves;
        planMs_ = 1e3 * watch.lap();
        layersMs_ = 0.0;
        if (!volumes) return;
        const bool anyNew = layers_.fill(loaded_.layerCasters(), view_.lights, view_.visible);
        if (anyNew) layersMs_ = 1e3 * watch.lap();
    }

    const LoadedScene& loaded() const { return loaded_; }
    SceneFacts facts() const { return sceneFactsOf(loaded_); }
    const FrameView& view() const { return view_; }
    double planMs(bool volumes) const { return planMs_ + (volumes ? layersMs_ : 0.0); }

    /// The scene with the groups of casters and the maps for the lights of a contender's `view`.
    GpuScene& sceneFor(const Needs& needs, const FrameView& view, const Renderer& renderer) {
        auto found = scenes_.find(needs);
        if (found == scenes_.end())
            found =
                scenes_.emplace(needs, uploadScene(loaded_, needs.volumes, capabilities_)).first;
        GpuScene& scene = found->second;
        prepareScene(scene, loaded_, view, renderer);
        return scene;
    }

  private:
    const LoadedScene& loaded_;
    const gl::Capabilities& capabilities_;
    Box bounds_;
    SceneTree tree_;
    std::map<Needs, GpuScene> scenes_;
    FrameView view_;
    KeptLayers layers_;
    double planMs_ = 0.0;
    double layersMs_ = 0.0;
};

/// A setting, ready to draw.
struct Contender {
    Contender(const Setting& setting_, const RenderSettings& render, Stage& stage_,
              const gl::Capabilities& capabilities)
        : setting(setting_), stage(stage_), renderer(render, capabilities),
          extendedLights(capabilities), needs(needsOf(render)) {}

    const Setting& setting;
    Stage& stage;
    Renderer renderer;
    ExtendedLights extendedLights;
    Needs needs;
    std::vector<double> frameMs, planMs, vertexRuns, repeatMs, reaching, shadowed;
    std::vector<FillCost> fills;
    std::vector<StageMs> stages;
};

/// The contenders of a task in one context, with their scenes.
class Course {
  public:
    Course(const LoadedScene& loaded, const Task& task)
        : task_(task), context_({task.width, task.height, task.samples, task.limits}),
          bounds_(worldBounds(loaded.scene)),
          timer_(task.timing.value_or(gl::bestTiming(context_.capabilities())),
                 context_.capabilities()) {
        for (const Setting& setting : task.settings) {
            RenderSettings render = setting.render;
            render.layout = setting.layout.value_or(bestLayout(context_.capabilities()));
            contenders_.push_back(std::make_unique<Contender>(
                setting, render, stageOf(setting.scene ? *setting.scene : loaded),
                context_.capabilities()));
        }
    }

    void warmUp() {
        look(0.0);
        for (int i = 0; i < task_.warmUp; ++i)
            for (auto& contender : contenders_)
                frameMs(*contender);
    }

    /// Draws frame `index` by all contenders, and now and then times the stages half a frame later.
    void measure(int index) {
        look(shareOf(index));
        inTurn(index, [&](Contender& contender) {
            contender.frameMs.push_back(frameMs(contender));
            contender.planMs.push_back(contender.stage.planMs(countsVolumes(contender)));
            contender.vertexRuns.push_back(static_cast<double>(contender.renderer.vertexRuns()));
            addFill(contender);
            addLights(contender);
        });
        if (index % framesPerStageFrame != 0) return;
        look(shareOf(index + 0.5));
        inTurn(index, [&](Contender& contender) {
            StageTimer clock(timer_, true);
            const auto spans = timed([&] { draw(contender, &clock); });
            contender.stages.push_back(stageMs(spans));
        });
    }

    /// Draws frame `index` by the contenders `who`; returns milliseconds for each.
    std::vector<double> frame(int index, std::span<const std::size_t> who) {
        look(shareOf(index));
        std::vector<double> times(who.size());
        for (std::size_t i = 0; i < who.size(); ++i) {
            const std::size_t k = (static_cast<std::size_t>(index) + i) % who.size();
            times[k] = frameMs(*contenders_[who[k]]);
            contenders_[who[k]]->frameMs.push_back(times[k]);
        }
        return times;
    }

    /// Draws one of the first frames again.
    void repeat(int index) {
        look(shareOf(index));
        inTurn(index,
               [&](Contender& contender) { contender.repeatMs.push_back(frameMs(contender)); });
    }

    Report report() {
        Report report{context_.capabilities(), timer_.timing(), {}};
        for (const auto& contender : contenders_)
            report.results.push_back(resultOf(*contender));
        return report;
    }

  private:
    double shareOf(double index) const { return index / task_.frames; }

    Stage& stageOf(const LoadedScene& loaded) {
        for (const auto& stage : stages_)
            if (stage->isOf(loaded)) return *stage;
        return *stages_.emplace_back(std::make_unique<Stage>(loaded, context_.capabilities()));
    }

    void look(double share) {
        FrameRequest request;
        request.frustum = task_.frustumAt(share);
        request.width = task_.width;
        request.height = task_.height;
        request.depth.near = task_.near;
        request.lights = task_.lightMoves ? movedLights(task_.lights, bounds_, task_.circle, share)
                                          : task_.lights;
        for (const auto& contender : contenders_)
            request.lightSamples =
                std::max(request.lightSamples, contender->renderer.settings().countedPoints());
        request.nearestDepths =
            std::any_of(contenders_.begin(), contenders_.end(), [](const auto& contender) {
                const auto& records = contender->needs.volumes;
                return records && records->volumes != VolumeLayout::planePairs;
            });
        for (const auto& stage : stages_)
            stage->look(request, task_.lightMoves, anyVolumes(*stage), mostShadowed());
    }

    /// Null: some contender has shadows of all lights.
    std::optional<std::size_t> mostShadowed() const {
        std::size_t most = 0;
        for (const auto& contender : contenders_) {
            const RenderSettings& settings = contender->renderer.settings();
            if (settings.shadows == ShadowMethod::none) continue;
            if (!settings.shadowedLights) return std::nullopt;
            most = std::max(most, *settings.shadowedLights);
        }
        return most;
    }

    bool anyVolumes(const Stage& stage) const {
        return std::any_of(contenders_.begin(), contenders_.end(), [&](const auto& contender) {
            return &contender->stage == &stage && countsVolumes(*contender);
        });
    }

    bool countsVolumes(const Contender& contender) const {
        return contender.needs.volumes &&
               !contender.renderer.policyFor(contender.stage.facts()).asksPoints();
    }

    /// Calls `use` for every contender, starting with another one each time.
    template <class Use>
    void inTurn(int index, Use use) {
        for (std::size_t i = 0; i < contenders_.size(); ++i)
            use(*contenders_[(static_cast<std::size_t>(index) + i) % contenders_.size()]);
    }

    /// The view that a contender draws.
    static FrameView viewFor(const Contender& contender) {
        FrameView view = contender.stage.view();
        view.divide(contender.setting.depthSlices);
        if (const auto most = contender.renderer.settings().shadowedLights)
            keepShadowed(view, *most);
        for (FrameLight& of : view.lights)
            of.points.resize(
                std::min(of.points.size(), contender.renderer.settings().countedPoints()));
        return view;
    }

    /// Adds the fill of the last frame.
    static void addFill(Contender& contender) {
        const VolumeRenderer* volumes = contender.renderer.volumes();
        const FrameView view = viewFor(contender);
        if (!volumes || volumes->layout() != VolumeLayout::planePairs ||
            contender.renderer.settings().maskScale != 1 || ExtendedLights::points(view) > 0)
            return;
        contender.fills.push_back(fillOf(contender.renderer.plan(), view));
    }

    /// Adds the counts of lights of the last frame.
    static void addLights(Contender& contender) {
        const FramePlan& plan = contender.renderer.plan();
        const FrameView view = viewFor(contender);
        std::size_t reaching = 0, shadowed = 0;
        for (std::size_t i = 0; i < view.lights.size(); ++i) {
            const bool reaches =
                std::any_of(plan.slices.begin(), plan.slices.end(),
                            [&](const SlicePlan& slice) { return !slice.lights[i].reach.empty(); });
            reaching += reaches;
            shadowed += reaches && view.lights[i].shadowed;
        }
        const bool any = contender.renderer.settings().shadows != ShadowMethod::none;
        contender.reaching.push_back(static_cast<double>(reaching));
        contender.shadowed.push_back(any ? static_cast<double>(shadowed) : 0.0);
    }

    void draw(Contender& contender, StageClock* clock) {
        Stage& stage = contender.stage;
        const FrameView view = viewFor(contender);
        drawWithExtents(contender.renderer, contender.extendedLights,
                        stage.sceneFor(contender.needs, view, contender.renderer), stage.loaded(),
                        view, clock);
        gl::requireNoError("drawing for measuring");
    }

    /// The spans of `use`'s drawing, repeated if the GPU was disturbed.
    template <class Use>
    std::vector<gl::SpanTimer::Span> timed(Use use) {
        for (int i = 0; i < mostTries; ++i) {
            use();
            auto spans = timer_.takeAll();
            const bool disturbed = std::any_of(spans.begin(), spans.end(),
                                               [](const auto& span) { return span.disturbed; });
            if (!disturbed) return spans;
        }
        throw Error(
            ExitStatus::unavailable,
            "The GPU's timer is disjoint in every frame; '--timing finish' needs no timer.");
    }

    double frameMs(Contender& contender) {
        // Builds before timing what only the first use needs, as it is no part of a frame. Moving
        // lights need nothing of that kind.
        contender.stage.sceneFor(contender.needs, viewFor(contender), contender.renderer);
        return timed([&] {
                   timer_.begin(0);
                   draw(contender, nullptr);
                   timer_.end();
               })
            .front()
            .milliseconds;
    }

    Result resultOf(const Contender& contender) {
        Result result;
        result.name = contender.setting.name;
        result.settings = contender.renderer.settings();
        result.frameMs = contender.frameMs;
        const auto stage = [&](double StageMs::*part) {
            std::vector<double> values;
            for (const StageMs& one : contender.stages)
                values.push_back(one.*part);
            return median(values);
        };
        result.stageMs = {stage(&StageMs::ambient), stage(&StageMs::map),
                          stage(&StageMs::silhouette), stage(&StageMs::rasterise),
                          stage(&StageMs::lit)};
        result.planMs = median(contender.planMs);
        result.vertexRuns = static_cast<std::size_t>(median(contender.vertexRuns));
        if (!contender.fills.empty()) {
            FillCost sum;
            for (const FillCost& fill : contender.fills)
                sum += fill;
            result.fill = sum.times(1.0 / static_cast<double>(contender.fills.size()));
        }
        const FrameView view = viewFor(contender);
        const GpuScene& scene = contender.stage.sceneFor(contender.needs, view, contender.renderer);
        result.sideBytes = scene.groups.sideBytes();
        result.capBytes = scene.groups.capBytes();
        for (const GpuBatch& batch : scene.batches) {
            if (!batch.owns) continue;
            result.sideBytes += batch.volumes.sideBytes();
            result.capBytes += batch.volumes.capBytes();
        }
        if (const VolumeRenderer* volumes = contender.renderer.volumes()) {
            result.sideBytes += volumes->sideBytes();
            result.capBytes += volumes->capBytes();
        }
        result.mapBytes = contender.renderer.mapBytes() + scene.primitiveMaps.bytes();
        result.tableBytes = contender.renderer.tableBytes();
        result.maskBytes = contender.renderer.maskBytes() + contender.extendedLights.bytes();
        result.lights = lightMethods(scene, view, contender.renderer);
        result.lightsReaching = static_cast<std::size_t>(median(contender.reaching));
        result.lightsShadowed = static_cast<std::size_t>(median(contender.shadowed));
        const auto first = contender.frameMs.begin();
        const auto repeated = static_cast<std::ptrdiff_t>(contender.repeatMs.size());
        result.repeated =
            median(contender.repeatMs) / median(std::vector<double>(first, first + repeated));
        return result;
    }

    const Task& task_;
    gl::HeadlessContext context_;
    Box bounds_;
    gl::SpanTimer timer_;
    std::vector<std::unique_ptr<Stage>> stages_;
    std::vector<std::unique_ptr<Contender>> contenders_;
};

Report measure(const LoadedScene& loaded, const Task& task,
               const std::function<void(double)>& progress) {
    Course course(loaded, task);
    progress(0.0);
    course.warmUp();
    for (int frame = 0; frame < task.frames; ++frame) {
        course.measure(frame);
        progress(static_cast<double>(frame + 1) / (task.frames + 1));
    }
    for (int frame = 0; frame < std::min(repeatedFrames, task.frames); ++frame)
        course.repeat(frame);
    progress(1.0);
    return course.report();
}

Turns::Turns(const LoadedScene& loaded, const Task& task)
    : course_(std::make_unique<Course>(loaded, task)) {
    course_->warmUp();
}

Turns::~Turns() = default;

std::vector<double> Turns::frame(int index, std::span<const std::size_t> who) {
    return course_->frame(index, who);
}

Report Turns::report() {
    return course_->report();
}

} // namespace edgeshade::bench
