#include "src/viewer/viewer.hpp"

#include "src/render/frame/light_methods.hpp"
#include "src/render/frame/volume_tint_pass.hpp"
#include "src/shadow/lights/scene_lights.hpp"
#include "src/shadow/view/kept_layers.hpp"
#include "src/shadow/view/scene_cameras.hpp"
#include "src/viewer/commands.hpp"
#include "src/viewer/convergence.hpp"
#include "src/viewer/day_clock.hpp"
#include "src/viewer/frame_clock.hpp"
#include "src/viewer/handle_drawing.hpp"
#include "src/viewer/interaction.hpp"
#include "src/viewer/light_following.hpp"
#include "src/viewer/light_rest.hpp"
#include "src/viewer/overlay_pass.hpp"
#include "src/viewer/pick.hpp"
#include "src/viewer/renderers.hpp"
#include "src/viewer/section_drawing.hpp"
#include "src/viewer/silhouettes.hpp"
#include "src/viewer/smoothing.hpp"
#include "src/viewer/stage_watch.hpp"
#include "src/viewer/sun_day.hpp"
#include "src/viewer/sun_drawing.hpp"
#include "src/viewer/sun_following.hpp"

#include "preprocess/base/stopwatch.hpp"
#include "preprocess/reading/animation_reading.hpp"
#include "src/render/frame/prepare_scene.hpp"
#include "src/scene/cut_loaded.hpp"
#include "src/scene/pose.hpp"
#include "src/scene/shadow_facts.hpp"
#include "src/settings/build_parts.hpp"

#include <algorithm>
#include <cmath>
#include <GLES2/gl2.h>

namespace edgeshade::viewer {
namespace {

/// One frame of this many has its stages timed, while statistics are queried.
constexpr int framesPerStageFrame = 16;

/// Milliseconds of a frame for building primitive maps where there are no threads.
constexpr double buildingMs = 4.0;

bool looksUp(const SideSettings& side) {
    return side.shadows == ShadowMethod::automatic || side.shadows == ShadowMethod::primitiveMap;
}

/// Whether shadow volumes may be needed for a side.
bool mayCount(const SideSettings& side) {
    return side.shadows == ShadowMethod::volumes || looksUp(side);
}

/// Whether volumes of a side, if any, are drawn from plane-pair records.
bool takesPlanePairs(const SideSettings& side) {
    return !mayCount(side) || volumeLayoutOf(side.multiplicity) == VolumeLayout::planePairs;
}

/// The same of all sides that the state shows.
bool takesPlanePairs(const ViewState& state) {
    return takesPlanePairs(state.left) && (!state.split || takesPlanePairs(state.right));
}

/// The part of a state that affects the picture, without its overlays.
nlohmann::ordered_json pictureOf(const ViewState& state) {
    nlohmann::ordered_json json = toJson(state);
    json.erase("show_lights");
    json.erase("chosen_light");
    return json;
}

/// Settings for counting hours of sunlight, the same as those of `edgeshade sunhours`.
constexpr SideSettings hoursSide{ShadowMethod::volumes};

} // namespace

/// The viewer's internals. Everything on the GPU can be dropped and recreated from the rest.
struct Viewer::Parts {
    struct Gpu {
        Gpu(const gl::Capabilities& capabilities_, const RenderSettings& settings)
            : capabilities(capabilities_), layout(settings.layout),
              renderers(settings, capabilities_), convergence(capabilities_),
              smoothing(capabilities_), sampleLights(capabilities_) {}

        VolumeTintPass& tintOf(const RenderSettings& drawn) {
            if (!tint || tintMethod != drawn.multiplicity)
                tint = std::make_unique<VolumeTintPass>(drawn, capabilities);
            tintMethod = drawn.multiplicity;
            return *tint;
        }

        VolumeRecords recordsOf(const SideSettings& side) const {
            return renderers.base().recordsOf(side.multiplicity, layout);
        }

        gl::Capabilities capabilities;
        SidesLayout layout;
        Renderers renderers;
        Convergence convergence;
        std::optional<SunHoursCount> hours; ///< empty unless the state shows them
        Smoothing smoothing;
        Convergence sampleLights; ///< for the picture that smoothing adds next
        OverlayPass overlay;
        std::unique_ptr<VolumeTintPass> tint; ///< created at first use
        MultiplicityMethod tintMethod = MultiplicityMethod::plane;
        std::optional<GpuScene> scene;
    };

    ViewerSettings settings;
    ViewState state;
    Stage stage;
    Interaction interaction;
    FrameClock clock;
    DayClock dayClock;
    SunDays sunDays;
    std::optional<LoadedScene> loaded;
    SceneTree tree;                         ///< the loaded scene's
    std::vector<AnimationTitle> animations; ///< the loaded scene's
    std::optional<Animation> animation;     ///< the chosen one
    KeptLayers layers;
    LightRest rest;
    bool mapsPending = false; ///< a light may get a primitive map soon
    std::unique_ptr<Gpu> gpu; ///< null: the context is lost
    bool dirty = true;
    std::size_t changes = 0; ///< counts changes of the picture, for smoothing
    std::size_t poses = 0;   ///< counts movements and changes of the scene
    bool timed = false;      ///< statistics have been queried
    bool unchecked = true;   ///< something new is drawn, which the GL may refuse
    bool showsHours = false; ///< whether the last picture shows hours of sunlight
    RecentMean frameMs, planMs, poseMs;
    int timedFrames = 0;
    std::optional<StageMs> stageMs; ///< of the last frame whose stages were timed
    std::optional<std::pair<glm::dvec4, EdgeCounts>> edgeCounts; ///< for the light at this position

    std::unique_ptr<Gpu> makeGpu(const gl::Capabilities& capabilities) const;
    GpuScene uploaded(const LoadedScene& scene, const Gpu& on) const;
    std::vector<VolumeRecords> recordsFor(const ViewState& of, const Gpu& on) const;
    void addVolumesFor(const ViewState& of, Gpu& on) const;
    LoadedScene cutFor(const ViewState& of) const;
    std::optional<GpuScene> uploadedCut(const LoadedScene& cut, const ViewState& of);
    void show(LoadedScene cut, std::optional<GpuScene> uploaded);
    void placeCut();
    void adopt(const ViewState& wanted);
    void chooseAnimation(Warnings& warnings);
    void applyPose();
    void applyGround();
    void applyCutouts();
    void applyCulling();
    void sceneMoved();
    void advanceMaps(double now);
    void draw();
    void drawSide(std::size_t side, const FrameView& view, Convergence& convergence,
                  StageClock* stageClock);
    const SideSettings& sideAt(std::size_t side) const {
        return side == 0 ? state.left : state.right;
    }
    /// Whether a side counts points for the shadows of lights with an extent.
    bool countsPoints(std::size_t side) const;
    SeenScene seenScene(const FrameView& view) const;
    CountedScene countedScene(const FrameView& view) const;
    void converge(double now);
    void seeHours(const FrameView& view);
    void countHours(double now);
    /// The view with samples at this offset within the pixels (subpixelOffset()).
    FrameView viewAt(const glm::dvec2& offset) const;
    std::array<Renderer*, 2> countingRenderers();
    void smooth(double now);
    void drawSides(const FrameView& view, Convergence& convergence, StageClock* stageClock);
    void groupCasters(FrameView& view);
    /// Whether a side tests visible points instead of counting volumes.
    bool asksPoints(const SideSettings& side);
    const EdgeCounts& edgesNow();
};

std::unique_ptr<Viewer::Parts::Gpu>
Viewer::Parts::makeGpu(const gl::Capabilities& capabilities) const {
    RenderSettings render = settings.render;
    render.layout = settings.layout.value_or(bestLayout(capabilities));
    auto made = std::make_unique<Gpu>(capabilities, render);
    if (loaded) {
        made->scene = uploaded(*loaded, *made);
        addVolumesFor(state, *made);
    }
    return made;
}

namespace {

/// Whether a page's worker can build maps of a scene that it knows as it was loaded, without the
/// ground. It cuts the scene as the page does. It doesn't know poses of batches that deform, which
/// are static once they are cut, nor the page's numbers of MASK materials that are cut away and
/// cast: they come after the ground's.
bool isKnownToWorker(const LoadedScene& scene) {
    if (!scene.uncut) return true;
    const Scene& before = scene.uncut->scene;
    const bool deforms = std::any_of(before.batches.begin(), before.batches.end(),
                                     [](const Batch& batch) { return batch.deforms(); });
    const bool masks =
        std::any_of(before.materials.begin(), before.materials.end(),
                    [](const Material& of) { return of.alphaMode == AlphaMode::mask; });
    return !deforms && !(masks && scene.scene.cutFrom->section.shadows == SectionShadows::whole);
}

} // namespace

GpuScene Viewer::Parts::uploaded(const LoadedScene& scene, const Gpu& on) const {
    GpuScene made = uploadScene(scene, on.recordsOf(state.left), on.capabilities);
    if (isKnownToWorker(scene)) made.primitiveMaps.buildWith(settings.mapWorker);
    return made;
}

/// The layouts of shadow data that the state draws from.
std::vector<VolumeRecords> Viewer::Parts::recordsFor(const ViewState& of, const Gpu& on) const {
    std::vector<VolumeRecords> records;
    for (const SideSettings* side : {&of.left, &of.right})
        if (mayCount(*side) && (side == &of.left || of.split))
            records.push_back(on.recordsOf(*side));
    if (of.sunHours) records.push_back(on.recordsOf(hoursSide));
    return records;
}

/// Uploads those that are missing.
void Viewer::Parts::addVolumesFor(const ViewState& of, Gpu& on) const {
    if (!loaded || !on.scene) return;
    for (const VolumeRecords& records : recordsFor(of, on))
        addVolumes(*on.scene, *loaded, records);
}

/// The loaded scene in the state's section, and with its ground.
LoadedScene Viewer::Parts::cutFor(const ViewState& of) const {
    LoadedScene cut = *loaded;
    cutScene(cut, of.section.value_or(Section()));
    if (cut.ground && of.ground) setGround(cut.scene, *of.ground);
    return cut;
}

/// Empty while the context is lost.
std::optional<GpuScene> Viewer::Parts::uploadedCut(const LoadedScene& cut, const ViewState& of) {
    if (!gpu || !gpu->scene) return std::nullopt;
    GpuScene made = uploadScene(cut, gpu->recordsOf(of.left), gpu->capabilities, &*gpu->scene);
    for (const VolumeRecords& records : recordsFor(of, *gpu))
        addVolumes(made, cut, records);
    if (isKnownToWorker(cut)) made.primitiveMaps.buildWith(settings.mapWorker);
    return made;
}

/// Replaces the loaded scene by another cut of it. Maps wait until lights rest in that.
void Viewer::Parts::show(LoadedScene cut, std::optional<GpuScene> uploaded) {
    loaded = std::move(cut);
    if (uploaded) {
        gpu->scene->primitiveMaps.clear();
        gpu->scene = std::move(uploaded);
    }
    rest.clear();
    unchecked = true;
}

/// Poses the whole of a scene that is cut, and cuts it again.
void Viewer::Parts::placeCut() {
    LoadedScene posed = *loaded;
    cutScene(posed, Section());
    placeScene(posed, poseAt(*animation, posed.scene, state.time));
    cutScene(posed, *state.section);
    if (posed.ground && state.ground) setGround(posed.scene, *state.ground);
    std::optional<GpuScene> uploaded = uploadedCut(posed, state);
    show(std::move(posed), std::move(uploaded));
}

/// Prepares everything that the next state needs before switching to it, so that a refusal changes
/// nothing.
void Viewer::Parts::adopt(const ViewState& wanted) {
    const ViewState next = withSun(state, wanted);
    if (next.animation != 0 && next.animation >= animations.size())
        throw Error(ExitStatus::usage, "animation is " + std::to_string(next.animation) +
                                           ", but the scene has " +
                                           std::to_string(animations.size()) + " animations.");
    unchecked = unchecked || next.debug != state.debug;
    if (gpu) {
        const std::size_t before = gpu->renderers.size();
        gpu->renderers.of(next.left, next);
        if (next.split) gpu->renderers.of(next.right, next);
        unchecked = unchecked || gpu->renderers.size() != before;
        gpu->renderers.dropUnusedTargets(next);
        addVolumesFor(next, *gpu);
    }
    std::optional<LoadedScene> cut;
    std::optional<GpuScene> uploaded;
    if (loaded && next.section != state.section) {
        cut = cutFor(next);
        uploaded = uploadedCut(*cut, next);
    }
    const bool rechosen = next.animation != state.animation;
    const bool posed = rechosen || next.time != state.time;
    const bool grounded = next.ground != state.ground;
    const bool cutOut = next.castCutouts != state.castCutouts;
    if (next.smooth > 1 && pictureOf(next) != pictureOf(state)) ++changes;
    const bool fromStart = rechosen && next.time == state.time;
    state = next;
    if (fromStart) state.time = 0.0;
    if (cut) {
        show(std::move(*cut), std::move(uploaded));
        sceneMoved();
    }
    Warnings known; // already reported when the scene was loaded
    if (rechosen) chooseAnimation(known);
    if (grounded) applyGround();
    if (cutOut) applyCutouts();
    applyCulling();
    if (posed) applyPose();
    dirty = true;
}

/// Reads the animation that the state selects.
void Viewer::Parts::chooseAnimation(Warnings& warnings) {
    animation.reset();
    if (state.animation >= animations.size()) return;
    animation = readAnimation(*loaded->document, warnings, animations[state.animation].index);
}

/// Poses batches, cameras and lights by the animation at the state's time.
void Viewer::Parts::applyPose() {
    if (!loaded) return;
    Stopwatch watch;
    const bool isCut = loaded->uncut != nullptr; // it is uploaded again, as placed
    std::vector<Placed> placed;
    for (const Batch& batch : loaded->scene.batches)
        placed.push_back({!batch.hidden, false});
    if (animation) {
        if (isCut) {
            placeCut();
        } else {
            const Pose pose = poseAt(*animation, loaded->scene, state.time);
            const std::vector<Placed> moved = placeScene(*loaded, pose);
            std::copy(moved.begin(), moved.end(), placed.begin());
        }
        std::vector<Light> lights = lightsOf(loaded->scene);
        followLights(state.lights, stage.lights, lights);
        stage.lights = std::move(lights);
    }
    if (gpu && gpu->scene && !isCut) {
        const std::vector<Batch>& batches = loaded->scene.batches;
        for (std::size_t i = 0; i < batches.size(); ++i) {
            gpu->scene->batches[i].worldFromBatch = batches[i].worldFromBatch;
            gpu->scene->batches[i].hidden = !placed[i].visible;
            if (placed[i].reshaped) uploadShape(*gpu->scene, *loaded, i);
        }
    }
    sceneMoved();
    poseMs.add(1e3 * watch.lap());
}

/// Shows, hides or restyles the ground, which always exists.
void Viewer::Parts::applyGround() {
    if (!loaded || !loaded->ground) return;
    const bool shown = state.ground.has_value();
    if (shown) {
        setGround(loaded->scene, *state.ground);
        const std::size_t material = *groundMaterialOf(loaded->scene);
        if (gpu && gpu->scene) gpu->scene->materials[material] = loaded->scene.materials[material];
    }
    if (shown == loaded->showsGround) return;
    loaded->showsGround = shown;
    if (!gpu || !gpu->scene) return;
    gpu->scene->primitiveMaps.clear(); // the set of surfaces that look up maps has changed
}

/// Makes MASK surfaces cast or not, where shadow is looked up.
void Viewer::Parts::applyCutouts() {
    if (!loaded) return;
    loaded->cutoutsCast = state.castCutouts;
    if (!gpu || !gpu->scene) return;
    gpu->scene->cutoutsCast = state.castCutouts;
    gpu->scene->primitiveMaps.clear();
}

/// Opposite-vertex records don't distinguish front from back: a side that draws from them shows all
/// surfaces from both sides. So do cut scenes, whose insides are in view.
void Viewer::Parts::applyCulling() {
    if (!loaded) return;
    loaded->scene.culls = state.culls && takesPlanePairs(state) && !loaded->uncut;
}

/// Drops everything computed for the batches' old places.
void Viewer::Parts::sceneMoved() {
    stage.bounds = worldBounds(loaded->scene);
    tree.update(loaded->scene);
    stage.framing = [this](double fovDegrees, double aspect, const glm::dvec3& direction) {
        return framingCamera(loaded->scene, fovDegrees, aspect, direction);
    };
    edgeCounts.reset();
    layers.clear();
    ++poses;
    ++changes;
    if (gpu && gpu->scene) gpu->scene->groups.clear();
    dirty = true;
}

const EdgeCounts& Viewer::Parts::edgesNow() {
    const Light& light = state.lights[state.chosenLight];
    if (!edgeCounts || edgeCounts->first != light.position)
        edgeCounts.emplace(light.position, countEdges(*loaded, light));
    return edgeCounts->second;
}

bool Viewer::Parts::asksPoints(const SideSettings& side) {
    return gpu->renderers.of(side, state).policyFor(sceneFactsOf(*gpu->scene)).asksPoints();
}

/// Splits the casters into groups that a stencil can count, and prepares the sides' techniques.
void Viewer::Parts::groupCasters(FrameView& view) {
    for (const SideSettings* side : {&state.left, &state.right}) {
        if (side == &state.right && !state.split) continue;
        gpu->renderers.of(*side, state).techniques().prepareScene(*gpu->scene, *loaded);
        if (!mayCount(*side)) continue;
        if (state.debug != DebugView::volumes && asksPoints(*side)) continue;
        layers.fill(loaded->layerCasters(), view.lights, view.visible);
        gpu->scene->groups.upload(*loaded, view.lights, gpu->recordsOf(*side));
    }
}

void Viewer::Parts::drawSide(std::size_t side, const FrameView& view, Convergence& convergence,
                             StageClock* stageClock) {
    SideSettings drawn = sideAt(side);
    if (state.debug == DebugView::volumes && looksUp(drawn)) drawn.shadows = ShadowMethod::volumes;
    Renderer& renderer = gpu->renderers.of(drawn, state);
    renderer.draw(*gpu->scene, view, stageClock, convergence.visibility(side));
    if (state.debug == DebugView::volumes && drawn.shadows == ShadowMethod::volumes)
        gpu->tintOf(renderer.settings())
            .draw(*gpu->scene, view, renderer.plan(), state.chosenLight);
}

bool Viewer::Parts::countsPoints(std::size_t side) const {
    RenderSettings drawn = settings.render;
    drawn.shadows = sideAt(side).shadows;
    return drawn.shadows != ShadowMethod::none && drawn.countedPoints() > 0;
}

SeenScene Viewer::Parts::seenScene(const FrameView& view) const {
    return {view.frustum, {view.width, view.height}, view.ground, view.culls, poses};
}

CountedScene Viewer::Parts::countedScene(const FrameView& view) const {
    CountedScene counted;
    counted.seen = seenScene(view);
    counted.lights = state.lights;
    const bool counts = !state.sunHours && state.debug == DebugView::none &&
                        (countsPoints(0) || (state.split && countsPoints(1)));
    for (const FrameLight& of : view.lights)
        counted.drawn.push_back(of.drawn && counts);
    counted.lightSamples = state.lightSamples;
    counted.sides = {state.left, state.split ? state.right : state.left};
    counted.cutouts = state.castCutouts;
    return counted;
}

/// Counts more points of lights with an extent; requests another frame when they improve the
/// picture.
void Viewer::Parts::converge(double now) {
    if (dirty || !loaded || !gpu || !gpu->scene || !gpu->convergence.wantsMore()) return;
    dirty = gpu->convergence.advance(countingRenderers(), *gpu->scene, *loaded, now);
    unchecked = unchecked || dirty;
}

/// Renderers of the sides that count points of lights.
std::array<Renderer*, 2> Viewer::Parts::countingRenderers() {
    std::array<Renderer*, 2> renderers{};
    for (std::size_t side = 0; side < (state.split ? 2u : 1u); ++side)
        if (countsPoints(side)) renderers[side] = &gpu->renderers.of(sideAt(side), state);
    return renderers;
}

/// Adds another picture to the displayed mean, with its own soft shadows, after the usual picture
/// has fully converged.
void Viewer::Parts::smooth(double now) {
    if (dirty || !gpu || !gpu->scene || !gpu->smoothing.wantsMore()) return;
    if (mapsPending || gpu->convergence.wantsMore()) return;
    FrameView view = viewAt(gpu->smoothing.offset());
    Convergence& lights = gpu->sampleLights;
    lights.see(countedScene(view), view);
    if (lights.wantsMore()) {
        lights.advance(countingRenderers(), *gpu->scene, *loaded, now);
        return;
    }
    groupCasters(view);
    dirty = gpu->smoothing.add([&] { drawSides(view, lights, nullptr); });
    unchecked = unchecked || dirty;
}

/// Starts, updates or ends the count of hours of sunlight.
void Viewer::Parts::seeHours(const FrameView& view) {
    if (!state.sunHours) return gpu->hours.reset();
    if (!gpu->hours) gpu->hours.emplace(gpu->capabilities);
    gpu->hours->see(seenScene(view), view, *state.sun, state.sunHoursStep);
}

/// Counts more positions of the sun; the last one triggers a redraw.
void Viewer::Parts::countHours(double now) {
    if (dirty || !gpu || !gpu->scene || !gpu->hours || !gpu->hours->wantsMore()) return;
    dirty = gpu->hours->advance(gpu->renderers.of(hoursSide, state), *gpu->scene, *loaded, now);
    unchecked = unchecked || dirty;
}

/// Continues building primitive maps for resting lights, if a side looks them up.
void Viewer::Parts::advanceMaps(double now) {
    rest.see(state.lights, now);
    const bool mayChange = dirty || mapsPending;
    mapsPending = false;
    if (!mayChange || !loaded || !gpu || !gpu->scene) return;
    // See-through surfaces look maps up even where volumes are counted.
    const bool seeThrough = gpu->scene->seeThrough && state.shading == Shading::full;
    const auto takesMaps = [&](const SideSettings& of) {
        return looksUp(of) || (seeThrough && mayCount(of));
    };
    const SideSettings* side = takesMaps(state.left)                   ? &state.left
                               : state.split && takesMaps(state.right) ? &state.right
                                                                       : nullptr;
    if (!side) return;
    RenderSettings wanted = settings.render;
    wanted.shading = state.shading;
    // Maps for see-through surfaces would suffice, but the other side may look up all surfaces.
    wanted.shadows = looksUp(*side) ? side->shadows : ShadowMethod::primitiveMap;
    const ShadowPolicy policy = backgroundPolicy(*gpu->scene, *loaded, wanted, gpu->capabilities);
    if (!policy.mayLookUp(restingEdges(*loaded))) return;
    FrameView view = viewAt(glm::dvec2(0.0));
    for (FrameLight& of : view.lights)
        of.atRest = rest.rests(of.light, now);
    if (prepareSceneMeanwhile(*gpu->scene, *loaded, view, policy, wanted.primitiveMap,
                              gpu->capabilities, buildingMs)) {
        dirty = true;
        ++changes;
    }
    for (const FrameLight& of : view.lights)
        if (of.drawn && of.shadowed && !gpu->scene->primitiveMaps.of(of.light)) mapsPending = true;
}

void Viewer::Parts::drawSides(const FrameView& view, Convergence& convergence,
                              StageClock* stageClock) {
    if (!state.split) return drawSide(0, view, convergence, stageClock);
    const int at = static_cast<int>(std::lround(state.splitAt * stage.width));
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, at, stage.height);
    if (at > 0) drawSide(0, view, convergence, stageClock);
    glScissor(at, 0, stage.width - at, stage.height);
    if (at < stage.width) drawSide(1, view, convergence, stageClock);
    glDisable(GL_SCISSOR_TEST);
    gpu->overlay.draw(splitTriangles(state, stage), stage.width, stage.height);
}

FrameView Viewer::Parts::viewAt(const glm::dvec2& offset) const {
    FrameRequest request;
    request.frustum =
        sampledAt(frustumOf(state.camera, stage.aspect()), offset, stage.width, stage.height);
    request.width = stage.width;
    request.height = stage.height;
    request.lights = state.lights;
    request.depth = settings.depth;
    request.ground = state.ground.has_value();
    request.nearestDepths = !takesPlanePairs(state);
    FrameView view = makeFrameView(loaded->scene, request, stage.bounds, tree);
    if (settings.chooseLights) settings.chooseLights(view, settings.render.shadowedLights);
    if (sunIsDown(state)) view.lights.front().drawn = false;
    return view;
}

void Viewer::Parts::draw() {
    Stopwatch watch;
    FrameView view = viewAt(glm::dvec2(0.0));
    gpu->convergence.see(countedScene(view), view);
    seeHours(view);
    const bool smooths = state.smooth > 1 && !state.sunHours && state.debug == DebugView::none;
    gpu->smoothing.see(changes, smooths ? state.smooth : 0, {stage.width, stage.height});
    showsHours = gpu->hours && gpu->hours->isComplete() && !state.playing && !state.dayPlays;
    const bool isUsual = !showsHours && gpu->smoothing.shown() == 0;
    if (isUsual) groupCasters(view);
    const double planSeconds = watch.lap();

    StageWatch stages; // it waits, so its frames are excluded from the frame times
    const bool watched = timed && timedFrames++ % framesPerStageFrame == 1;
    StageClock* const stageClock = watched ? &stages : nullptr;
    if (showsHours)
        gpu->hours->draw(state.background);
    else if (isUsual)
        drawSides(view, gpu->convergence, stageClock);
    else
        gpu->smoothing.show();
    if (state.showLights && state.section)
        gpu->overlay.draw(sectionTriangles(state, stage), stage.width, stage.height);
    if (state.showLights && state.sun)
        gpu->overlay.draw(sunTriangles(sunDays.of(*state.sun), state, stage), stage.width,
                          stage.height);
    if (state.showLights)
        gpu->overlay.draw(handleTriangles(state, stage), stage.width, stage.height);
    // Querying errors waits for the GL in a browser; a draw that worked once keeps working.
    if (unchecked) gl::requireNoError("drawing the view");
    unchecked = false;
    planMs.add(1e3 * planSeconds);
    if (watched) {
        stageMs = stages.stages();
        return;
    }
    if (timed) waitForPicture();
    frameMs.add(1e3 * (planSeconds + watch.lap()));
}

Viewer::Viewer(const gl::Capabilities& capabilities, const ViewerSettings& settings)
    : parts_(std::make_unique<Parts>()) {
    parts_->settings = settings;
    parts_->state.background = settings.render.background;
    parts_->stage.firstHit = [parts = parts_.get()](const Ray& ray) {
        return parts->loaded ? firstHit(parts->loaded->scene, ray) : std::nullopt;
    };
    parts_->gpu = parts_->makeGpu(capabilities);
}

Viewer::~Viewer() = default;

void Viewer::show(LoadedScene scene) {
    Parts& parts = *parts_;
    std::vector<AnimationTitle> animations;
    if (scene.document) animations = animationTitles(*scene.document);
    // The ground is always added, so that it can be shown at any time.
    const GroundChoice ground =
        scene.ground || hasFloor(scene.scene) ? scene.ground : GroundChoice(Ground{});
    if (!scene.ground) addGround(scene, Ground{});
    std::optional<GpuScene> uploaded;
    if (parts.gpu && parts.gpu->scene) parts.gpu->scene->primitiveMaps.clear();
    if (parts.gpu) uploaded = parts.uploaded(scene, *parts.gpu);
    parts.loaded = std::move(scene);
    parts.animations = std::move(animations);
    for (parts.state.animation = 0; parts.state.animation < parts.animations.size();
         ++parts.state.animation) {
        parts.chooseAnimation(parts.loaded->scene.warnings);
        if (parts.animation) break;
    }
    if (!parts.animation) parts.state.animation = 0;
    parts.state.section.reset();
    parts.state.time = 0.0;
    parts.state.playing = false;
    parts.state.ground = ground;
    parts.state.castCutouts = parts.loaded->cutoutsCast;
    parts.state.culls = parts.loaded->scene.culls;
    if (parts.gpu) {
        parts.gpu->scene = std::move(uploaded);
        parts.addVolumesFor(parts.state, *parts.gpu);
    }
    parts.interaction = Interaction();
    parts.rest.clear();
    parts.unchecked = true;
    parts.sceneMoved();
    parts.stage.lights = lightsOf(parts.loaded->scene);
    parts.stage.animations = parts.animations.size();
    parts.poseMs = {};
    parts.state = framed(parts.state, parts.stage);
    if (parts.animation) parts.applyPose();
    parts.applyGround();
    parts.applyCulling();
}

bool Viewer::hasScene() const {
    return parts_->loaded.has_value();
}

void Viewer::resize(int width, int height, double pixelRatio) {
    parts_->stage.width = std::max(1, width);
    parts_->stage.height = std::max(1, height);
    parts_->stage.pixelRatio = pixelRatio > 0.0 ? pixelRatio : 1.0;
    parts_->unchecked = true;
    invalidate();
}

const ViewState& Viewer::state() const {
    return parts_->state;
}

void Viewer::change(const nlohmann::ordered_json& changes) {
    parts_->adopt(changed(parts_->state, changes));
}

void Viewer::pointerDown(const Pointer& pointer) {
    parts_->adopt(parts_->interaction.down(pointer, parts_->state, parts_->stage));
}

void Viewer::pointerMove(const Pointer& pointer) {
    if (const auto next = parts_->interaction.move(pointer, parts_->state, parts_->stage))
        parts_->adopt(*next);
}

void Viewer::pointerUp(const Pointer& pointer) {
    parts_->interaction.up(pointer);
}

void Viewer::wheel(double x, double y, double notches) {
    parts_->adopt(parts_->interaction.wheel({x, y}, notches, parts_->state, parts_->stage));
}

void Viewer::run(Command command) {
    parts_->adopt(after(command, parts_->state, parts_->stage));
}

std::vector<FileCamera> Viewer::cameras() const {
    return parts_->loaded ? fileCameras(parts_->loaded->scene) : std::vector<FileCamera>();
}

std::vector<std::string> Viewer::animations() const {
    std::vector<std::string> names;
    for (const AnimationTitle& title : parts_->animations)
        names.push_back(title.name);
    return names;
}

double Viewer::animationSeconds() const {
    return parts_->animation ? parts_->animation->duration : 0.0;
}

LightPoints Viewer::lightPoints() const {
    if (!parts_->gpu) return {};
    const Convergence& convergence = parts_->gpu->convergence;
    return {convergence.shown(), convergence.of()};
}

LightPoints Viewer::smoothing() const {
    if (!parts_->gpu) return {};
    return {parts_->gpu->smoothing.shown(), parts_->gpu->smoothing.of()};
}

std::optional<SunHours> Viewer::sunHours() const {
    const Parts& parts = *parts_;
    if (!parts.state.sunHours || !parts.gpu || !parts.gpu->hours) return std::nullopt;
    return parts.gpu->hours->progress();
}

bool Viewer::showsSunHours() const {
    return parts_->showsHours && parts_->gpu && parts_->gpu->hours;
}

std::optional<std::uint32_t> Viewer::sunHoursAt(double x, double y) const {
    const Parts& parts = *parts_;
    if (!showsSunHours()) return std::nullopt;
    return parts.gpu->hours->at(glm::ivec2(std::floor(x), std::floor(y)));
}

double Viewer::sceneSize() const {
    return parts_->loaded ? parts_->stage.bounds.diagonal() : 0.0;
}

nlohmann::ordered_json Viewer::sun() const {
    const auto& sun = parts_->state.sun;
    if (!sun) return nullptr;
    return toJson(sun->position(), parts_->sunDays.of(*sun));
}

bool Viewer::frame(double now) {
    Parts& parts = *parts_;
    if (parts.clock.advance(now, animationSeconds(), parts.state)) parts.applyPose();
    if (const auto sun = parts.dayClock.advance(now, parts.state)) {
        ViewState next = parts.state;
        next.sun = sun;
        parts.adopt(next);
    }
    parts.advanceMaps(now);
    parts.converge(now);
    parts.countHours(now);
    parts.smooth(now);
    if (!parts.dirty || !parts.gpu) return false;
    parts.dirty = false;
    if (parts.loaded) {
        parts.draw();
    } else {
        const glm::vec3& color = parts.state.background;
        glClearColor(color.r, color.g, color.b, 1.0f);
        glClear(GL_COLOR_BUFFER_BIT);
    }
    return true;
}

void Viewer::invalidate() {
    parts_->dirty = true;
}

bool Viewer::wantsFrame() const {
    const bool plays = parts_->state.playing && animationSeconds() > 0.0;
    return parts_->gpu &&
           (parts_->dirty || plays || parts_->state.dayPlays || parts_->mapsPending ||
            parts_->gpu->convergence.wantsMore() || parts_->gpu->smoothing.wantsMore() ||
            (parts_->gpu->hours && parts_->gpu->hours->wantsMore()));
}

FrameStats Viewer::stats() const {
    Parts& parts = *parts_;
    parts.timed = true;
    FrameStats stats;
    if (!parts.loaded) return stats;
    stats.frameMs = parts.frameMs.mean();
    stats.planMs = parts.planMs.mean();
    stats.poseMs = parts.poseMs.mean();
    stats.stageMs = parts.stageMs;
    stats.triangles = parts.loaded->scene.triangleCount();
    const EdgeCounts& counts = parts.edgesNow();
    stats.edges = counts.edges;
    stats.records = counts.records;
    stats.silhouettes = counts.silhouettes;
    if (parts.gpu && parts.gpu->scene)
        stats.shadowBytes = parts.gpu->scene->shadowBytes() + parts.gpu->renderers.volumeBytes() +
                            parts.gpu->renderers.maskBytes() + parts.gpu->convergence.bytes() +
                            parts.gpu->smoothing.bytes() + parts.gpu->sampleLights.bytes() +
                            (parts.gpu->hours ? parts.gpu->hours->bytes() : 0);
    if (parts.gpu) stats.mapBytes = parts.gpu->renderers.mapBytes();
    if (parts.gpu && parts.gpu->scene) {
        stats.primitiveMapBytes = parts.gpu->scene->primitiveMaps.bytes();
        FrameView view;
        for (const Light& light : parts.state.lights)
            view.lights.push_back({light, {}});
        const Renderer& left = parts.gpu->renderers.of(parts.state.left, parts.state);
        stats.lights = lightMethods(*parts.gpu->scene, view, left);
    }
    return stats;
}

void Viewer::forgetGpu() {
    parts_->gpu.reset();
}

void Viewer::restoreGpu(const gl::Capabilities& capabilities) {
    parts_->gpu.reset();
    parts_->gpu = parts_->makeGpu(capabilities);
    parts_->unchecked = true;
    parts_->applyPose();
    invalidate();
}

nlohmann::ordered_json toJson(const LightPoints& points) {
    return {{"shown", points.shown}, {"of", points.of}};
}

nlohmann::ordered_json toJson(const FrameStats& stats) {
    nlohmann::ordered_json json = {{"frame_ms", stats.frameMs},
                                   {"plan_ms", stats.planMs},
                                   {"pose_ms", stats.poseMs},
                                   {"triangles", stats.triangles},
                                   {"edges", stats.edges},
                                   {"records", stats.records},
                                   {"silhouettes", stats.silhouettes},
                                   {"shadow_bytes", stats.shadowBytes},
                                   {"map_bytes", stats.mapBytes},
                                   {"primitive_map_bytes", stats.primitiveMapBytes}};
    json["lights"] = nlohmann::ordered_json::array();
    for (const LightMethod& light : stats.lights)
        json["lights"].push_back({{"method", light.method},
                                  {"why", light.why},
                                  {"build_ms", light.buildMs},
                                  {"bytes", light.bytes}});
    if (stats.stageMs)
        json["stage_ms"] = {{"ambient", stats.stageMs->ambient},
                            {"map", stats.stageMs->map},
                            {"silhouette", stats.stageMs->silhouette},
                            {"rasterise", stats.stageMs->rasterise},
                            {"lit", stats.stageMs->lit}};
    return json;
}

} // namespace edgeshade::viewer
