#include "src/viewer/viewer_parts.hpp"

#include "preprocess/base/stopwatch.hpp"
#include "src/shadow/lights/scene_lights.hpp"
#include "src/viewer/commands.hpp"
#include "src/viewer/light_following.hpp"
#include "src/viewer/side_needs.hpp"
#include "src/viewer/sun_following.hpp"

#include <algorithm>

namespace edgeshade::viewer {
namespace {

/// The part of a state that affects the picture, without its overlays.
nlohmann::ordered_json pictureOf(const ViewState& state) {
    nlohmann::ordered_json json = toJson(state);
    json.erase("show_lights");
    json.erase("chosen_light");
    return json;
}

} // namespace

std::unique_ptr<ViewerGpu> ViewerParts::makeGpu(const gl::Capabilities& capabilities) const {
    RenderSettings render = settings.render;
    render.layout = settings.layout.value_or(bestLayout(capabilities));
    auto made = std::make_unique<ViewerGpu>(capabilities, render, settings.mapWorker);
    if (shown) made->scene = made->uploaded(shown->loaded, state, nullptr);
    return made;
}

void ViewerParts::show(LoadedScene scene) {
    // The ground is always added, so that it can be shown at any time.
    const GroundChoice ground =
        scene.ground || hasFloor(scene.scene) ? scene.ground : GroundChoice(Ground{});
    if (!scene.ground) addGround(scene, Ground{});
    std::optional<GpuScene> uploaded;
    if (gpuScene()) gpuScene()->primitiveMaps.clear();
    if (gpu) uploaded = gpu->uploaded(scene, state, nullptr);
    shown.emplace(std::move(scene));
    if (gpu) gpu->scene = std::move(uploaded);

    state.animation = shown->animationIndex();
    state.section.reset();
    state.time = 0.0;
    state.playing = false;
    state.ground = ground;
    state.castCutouts = shown->loaded.cutoutsCast;
    state.culls = shown->loaded.scene.culls;
    interaction = Interaction();
    rest.clear();
    unchecked = true;
    sceneMoved();
    stage.lights = lightsOf(shown->loaded.scene);
    stage.animations = shown->animations().size();
    meter.forgetPoses();
    state = framed(state, stage);
    if (shown->animation()) applyPose();
    applyGround();
    applyCulling();
}

std::optional<GpuScene> ViewerParts::uploadedCut(const LoadedScene& cut,
                                                 const ViewState& of) const {
    if (!gpuScene()) return std::nullopt;
    return gpu->uploaded(cut, of, gpuScene());
}

void ViewerParts::showCut(LoadedScene cut, std::optional<GpuScene> uploaded) {
    shown->loaded = std::move(cut);
    if (uploaded) {
        gpu->scene->primitiveMaps.clear();
        gpu->scene = std::move(uploaded);
    }
    rest.clear();
    unchecked = true;
}

void ViewerParts::adopt(const ViewState& wanted) {
    const ViewState next = withSun(state, wanted);
    const std::size_t animationCount = shown ? shown->animations().size() : 0;
    if (next.animation != 0 && next.animation >= animationCount)
        throw Error(ExitStatus::usage, "animation is " + std::to_string(next.animation) +
                                           ", but the scene has " + std::to_string(animationCount) +
                                           " animations.");
    unchecked = unchecked || next.debug != state.debug;
    if (gpu) {
        const std::size_t before = gpu->renderers.size();
        gpu->renderers.of(next.left, next);
        if (next.split) gpu->renderers.of(next.right, next);
        unchecked = unchecked || gpu->renderers.size() != before;
        gpu->renderers.dropUnusedTargets(next);
        if (shown) gpu->addVolumesFor(next, shown->loaded);
    }
    std::optional<LoadedScene> cut;
    std::optional<GpuScene> uploaded;
    if (shown && next.section != state.section) {
        cut = shown->cutFor(next);
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
        showCut(std::move(*cut), std::move(uploaded));
        sceneMoved();
    }
    Warnings known; // already reported when the scene was loaded
    if (rechosen && shown) shown->chooseAnimation(state.animation, known);
    if (grounded) applyGround();
    if (cutOut) applyCutouts();
    applyCulling();
    if (posed) applyPose();
    dirty = true;
}

void ViewerParts::applyPose() {
    if (!shown) return;
    Stopwatch watch;
    const bool isCut = shown->loaded.uncut != nullptr; // it is uploaded again, as placed
    std::vector<Placed> placed;
    for (const Batch& batch : shown->loaded.scene.batches)
        placed.push_back({!batch.hidden, false});
    if (shown->animation()) {
        if (isCut) {
            LoadedScene cut = shown->cutPosed(state);
            std::optional<GpuScene> uploaded = uploadedCut(cut, state);
            showCut(std::move(cut), std::move(uploaded));
        } else {
            const Pose pose = poseAt(*shown->animation(), shown->loaded.scene, state.time);
            const std::vector<Placed> moved = placeScene(shown->loaded, pose);
            std::copy(moved.begin(), moved.end(), placed.begin());
        }
        std::vector<Light> lights = lightsOf(shown->loaded.scene);
        followLights(state.lights, stage.lights, lights);
        stage.lights = std::move(lights);
    }
    if (GpuScene* const gpuScene = this->gpuScene(); gpuScene && !isCut) {
        const std::vector<Batch>& batches = shown->loaded.scene.batches;
        for (std::size_t i = 0; i < batches.size(); ++i) {
            gpuScene->batches[i].worldFromBatch = batches[i].worldFromBatch;
            gpuScene->batches[i].hidden = !placed[i].visible;
            if (placed[i].reshaped) uploadShape(*gpuScene, shown->loaded, i);
        }
    }
    sceneMoved();
    meter.addPoseMs(1e3 * watch.lap());
}

void ViewerParts::applyGround() {
    if (!shown || !shown->loaded.ground) return;
    LoadedScene& loaded = shown->loaded;
    const bool isShown = state.ground.has_value();
    if (isShown) {
        setGround(loaded.scene, *state.ground);
        const std::size_t material = *groundMaterialOf(loaded.scene);
        if (gpuScene()) gpuScene()->materials[material] = loaded.scene.materials[material];
    }
    if (isShown == loaded.showsGround) return;
    loaded.showsGround = isShown;
    // The set of surfaces that look up maps has changed.
    if (gpuScene()) gpuScene()->primitiveMaps.clear();
}

void ViewerParts::applyCutouts() {
    if (!shown) return;
    shown->loaded.cutoutsCast = state.castCutouts;
    if (!gpuScene()) return;
    gpuScene()->cutoutsCast = state.castCutouts;
    gpuScene()->primitiveMaps.clear();
}

void ViewerParts::applyCulling() {
    if (!shown) return;
    shown->loaded.scene.culls = state.culls && takesPlanePairs(state) && !shown->loaded.uncut;
}

void ViewerParts::sceneMoved() {
    stage.bounds = worldBounds(shown->loaded.scene);
    stage.framing = [this](double fovDegrees, double aspect, const glm::dvec3& direction) {
        return framingCamera(shown->loaded.scene, fovDegrees, aspect, direction);
    };
    shown->moved();
    ++poses;
    ++changes;
    if (gpuScene()) gpuScene()->groups.clear();
    dirty = true;
}

} // namespace edgeshade::viewer
