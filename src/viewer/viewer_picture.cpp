#include "src/viewer/viewer_parts.hpp"

#include "preprocess/base/stopwatch.hpp"
#include "src/render/frame/prepare_scene.hpp"
#include "src/scene/shadow_facts.hpp"
#include "src/viewer/handle_drawing.hpp"
#include "src/viewer/section_drawing.hpp"
#include "src/viewer/side_needs.hpp"
#include "src/viewer/sun_drawing.hpp"
#include "src/viewer/sun_following.hpp"

#include <cmath>
#include <GLES2/gl2.h>

namespace edgeshade::viewer {
namespace {

/// Milliseconds of a frame for building primitive maps where there are no threads.
constexpr double buildingMs = 4.0;

} // namespace

bool ViewerParts::asksPoints(const SideSettings& side) {
    return gpu->renderers.of(side, state).policyFor(sceneFactsOf(*gpu->scene)).asksPoints();
}

void ViewerParts::groupCasters(FrameView& view) {
    for (const SideSettings* side : {&state.left, &state.right}) {
        if (side == &state.right && !state.split) continue;
        gpu->renderers.of(*side, state).techniques().prepareScene(*gpu->scene, shown->loaded);
        if (!mayCount(*side)) continue;
        if (state.debug != DebugView::volumes && asksPoints(*side)) continue;
        shown->layers().fill(shown->loaded.layerCasters(), view.lights, view.visible);
        gpu->scene->groups.upload(shown->loaded, view.lights, gpu->recordsOf(*side));
    }
}

void ViewerParts::drawSide(std::size_t side, const FrameView& view, Convergence& convergence,
                           StageClock* stageClock) {
    SideSettings drawn = sideAt(side);
    if (state.debug == DebugView::volumes && looksUp(drawn)) drawn.shadows = ShadowMethod::volumes;
    Renderer& renderer = gpu->renderers.of(drawn, state);
    renderer.draw(*gpu->scene, view, stageClock, convergence.visibility(side));
    if (state.debug == DebugView::volumes && drawn.shadows == ShadowMethod::volumes)
        gpu->tintOf(renderer.settings())
            .draw(*gpu->scene, view, renderer.plan(), state.chosenLight);
}

bool ViewerParts::countsPoints(std::size_t side) const {
    RenderSettings drawn = settings.render;
    drawn.shadows = sideAt(side).shadows;
    return drawn.shadows != ShadowMethod::none && drawn.countedPoints() > 0;
}

SeenScene ViewerParts::seenScene(const FrameView& view) const {
    return {view.frustum, {view.width, view.height}, view.ground, view.culls, poses};
}

CountedScene ViewerParts::countedScene(const FrameView& view) const {
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

void ViewerParts::converge(double now) {
    if (dirty || !shown || !gpu || !gpu->scene || !gpu->convergence.wantsMore()) return;
    dirty = gpu->convergence.advance(countingRenderers(), *gpu->scene, shown->loaded, now);
    unchecked = unchecked || dirty;
}

std::array<Renderer*, 2> ViewerParts::countingRenderers() {
    std::array<Renderer*, 2> renderers{};
    for (std::size_t side = 0; side < (state.split ? 2u : 1u); ++side)
        if (countsPoints(side)) renderers[side] = &gpu->renderers.of(sideAt(side), state);
    return renderers;
}

void ViewerParts::smooth(double now) {
    if (dirty || !gpu || !gpu->scene || !gpu->smoothing.wantsMore()) return;
    if (mapsPending || gpu->convergence.wantsMore()) return;
    FrameView view = viewAt(gpu->smoothing.offset());
    Convergence& lights = gpu->sampleLights;
    lights.see(countedScene(view), view);
    if (lights.wantsMore()) {
        lights.advance(countingRenderers(), *gpu->scene, shown->loaded, now);
        return;
    }
    groupCasters(view);
    dirty = gpu->smoothing.add([&] { drawSides(view, lights, nullptr); });
    unchecked = unchecked || dirty;
}

void ViewerParts::seeHours(const FrameView& view) {
    if (!state.sunHours) return gpu->hours.reset();
    if (!gpu->hours) gpu->hours.emplace(gpu->capabilities);
    gpu->hours->see(seenScene(view), view, *state.sun, state.sunHoursStep);
}

void ViewerParts::countHours(double now) {
    if (dirty || !gpu || !gpu->scene || !gpu->hours || !gpu->hours->wantsMore()) return;
    dirty =
        gpu->hours->advance(gpu->renderers.of(hoursSide, state), *gpu->scene, shown->loaded, now);
    unchecked = unchecked || dirty;
}

void ViewerParts::advanceMaps(double now) {
    rest.see(state.lights, now);
    const bool mayChange = dirty || mapsPending;
    mapsPending = false;
    if (!mayChange || !shown || !gpu || !gpu->scene) return;
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
    const ShadowPolicy policy =
        backgroundPolicy(*gpu->scene, shown->loaded, wanted, gpu->capabilities);
    if (!policy.mayLookUp(restingEdges(shown->loaded))) return;
    FrameView view = viewAt(glm::dvec2(0.0));
    for (FrameLight& of : view.lights)
        of.atRest = rest.rests(of.light, now);
    if (prepareSceneMeanwhile(*gpu->scene, shown->loaded, view, policy, wanted.primitiveMap,
                              gpu->capabilities, buildingMs)) {
        dirty = true;
        ++changes;
    }
    for (const FrameLight& of : view.lights)
        if (of.drawn && of.shadowed && !gpu->scene->primitiveMaps.of(of.light)) mapsPending = true;
}

void ViewerParts::drawSides(const FrameView& view, Convergence& convergence,
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

FrameView ViewerParts::viewAt(const glm::dvec2& offset) const {
    FrameRequest request;
    request.frustum =
        sampledAt(frustumOf(state.camera, stage.aspect()), offset, stage.width, stage.height);
    request.width = stage.width;
    request.height = stage.height;
    request.lights = state.lights;
    request.depth = settings.depth;
    request.ground = state.ground.has_value();
    request.nearestDepths = !takesPlanePairs(state);
    FrameView view = makeFrameView(shown->loaded.scene, request, stage.bounds, shown->tree());
    if (settings.chooseLights) settings.chooseLights(view, settings.render.shadowedLights);
    if (sunIsDown(state)) view.lights.front().drawn = false;
    return view;
}

void ViewerParts::draw() {
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

    std::optional<StageWatch> stages = meter.stageWatch();
    if (showsHours)
        gpu->hours->draw(state.background);
    else if (isUsual)
        drawSides(view, gpu->convergence, stages ? &*stages : nullptr);
    else
        gpu->smoothing.show();
    drawOverlays();
    // Querying errors waits for the GL in a browser; a draw that worked once keeps working.
    if (unchecked) gl::requireNoError("drawing the view");
    unchecked = false;
    meter.addPlanMs(1e3 * planSeconds);
    if (stages) return meter.add(*stages);
    if (meter.isRequested()) waitForPicture();
    meter.addFrameMs(1e3 * (planSeconds + watch.lap()));
}

void ViewerParts::drawOverlays() {
    if (!state.showLights) return;
    const auto draw = [&](const auto& triangles) {
        gpu->overlay.draw(triangles, stage.width, stage.height);
    };
    if (state.section) draw(sectionTriangles(state, stage));
    if (state.sun) draw(sunTriangles(sunDays.of(*state.sun), state, stage));
    draw(handleTriangles(state, stage));
}

} // namespace edgeshade::viewer
