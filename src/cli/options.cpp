#include "src/cli/options.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/scene/animation.hpp"
#include "src/cli/number_text.hpp"
#include "src/cli/setting_text.hpp"
#include "src/scene/cut_loaded.hpp"
#include "src/scene/pose.hpp"
#include "src/shadow/lights/scene_lights.hpp"
#include "src/shadow/view/framing.hpp"
#include "src/shadow/view/scene_cameras.hpp"
#include "src/viewer/section_state.hpp"

#include <charconv>
#include <glm/gtc/type_ptr.hpp>
#include <tuple>

namespace edgeshade::cli {
namespace {

/// Parses a matrix column by column.
glm::dmat4 matrixFrom(const std::string& text, const std::string& option) {
    return glm::make_mat4(numbersFrom<16>(text, option, "16 numbers with commas").data());
}

void addViewOptions(CLI::App& verb, ViewOptions& options) {
    addOption(verb, "--size", [&](const std::string& text) {
        std::tie(options.width, options.height) = sizeFrom(text, "--size");
    });
    addOption(verb, "--camera-from",
              [&](const std::string& text) { options.from = vectorFrom(text, "--camera-from"); });
    addOption(verb, "--camera-to",
              [&](const std::string& text) { options.to = vectorFrom(text, "--camera-to"); });
    CLI::Option* const matrix = addOption(verb, "--camera-matrix", [&](const std::string& text) {
        options.cameraMatrix = rigidView(matrixFrom(text, "--camera-matrix"));
    });
    for (const char* other : {"--camera-from", "--camera-to"})
        matrix->excludes(verb.get_option(other));
    addNumber(verb, "--ortho", options.orthoHeight);
    addNumber(verb, "--fov", options.fovDegrees);
    CLI::Option* const camera = addText(verb, "--camera", options.camera);
    for (const char* other :
         {"--camera-from", "--camera-to", "--camera-matrix", "--ortho", "--fov"})
        camera->excludes(verb.get_option(other));
    addNumber(verb, "--near", options.depth.near);
}

} // namespace

std::pair<int, int> sizeFrom(const std::string& text, const std::string& option) {
    int values[2] = {};
    const char* at = text.data();
    const char* end = text.data() + text.size();
    for (int i = 0; i < 2; ++i) {
        const auto result = std::from_chars(at, end, values[i]);
        const bool separated = i == 1 ? result.ptr == end : result.ptr != end && *result.ptr == 'x';
        if (result.ec != std::errc() || !separated || values[i] < 1 || values[i] > 65536)
            throw CLI::ValidationError(option, "'" + text +
                                                   "' is not of the form WIDTHxHEIGHT with "
                                                   "numbers from 1 to 65536");
        at = result.ptr + 1;
    }
    return {values[0], values[1]};
}

CasterSettings CasterChanges::on(CasterSettings settings) const {
    settings.weldTolerance = weldTolerance.value_or(autoWeld ? 0.0 : settings.weldTolerance);
    settings.autoWeld = autoWeld;
    settings.flatTolerance = flatTolerance.value_or(settings.flatTolerance);
    settings.casterError = casterError.value_or(settings.casterError);
    settings.instances = instances.value_or(settings.instances);
    return settings;
}

void addCasterChanges(CLI::App& verb, CasterChanges& changes) {
    const Values& tolerances = optionOf(verb.get_name(), "--weld-tolerance").values;
    addOption(verb, "--weld-tolerance", [&](const std::string& text) {
        changes.weldTolerance = numberIn(tolerances, "--weld-tolerance", text);
        changes.autoWeld = !changes.weldTolerance;
    });
    addNumber(verb, "--flat-tolerance", changes.flatTolerance);
    addNumber(verb, "--caster-error", changes.casterError);
    addWords(
        verb, "--instances", changes.instances,
        std::vector{InstanceChoice::automatic, InstanceChoice::shared, InstanceChoice::repeated});
}

void addCasterOptions(CLI::App& verb, CasterOptions& options) {
    addCasterChanges(verb, options.changes);
    verb.add_flag("--cast-masked", options.castMasked);
}

void addLimitOptions(CLI::App& verb, ReadingLimits& limits) {
    addNumber(verb, "--max-file", limits.fileBytes);
    addNumber(verb, "--max-memory", limits.memoryBytes);
    addNumber(verb, "--max-triangles", limits.triangles);
    addNumber(verb, "--max-nodes", limits.nodes);
    addNumber(verb, "--max-node-depth", limits.nodeDepth);
}

CLI::Option* addSceneFile(CLI::App& verb, SceneOptions& options) {
    return verb.add_option("FILE", options.input, "The scene, .gltf or .glb, packed or not");
}

void addSceneOptions(CLI::App& verb, SceneOptions& options) {
    addUnlitSceneOptions(verb, options);
    addLightOptions(verb, options.view.lights);
}

void addUnlitSceneOptions(CLI::App& verb, SceneOptions& options) {
    addViewOptions(verb, options.view);
    addCasterOptions(verb, options.casters);
    addWords(verb, "--gl-limits", options.glLimits,
             std::vector{gl::Limits::device, gl::Limits::es2Minimum});
    addText(verb, "--variant", options.variant);
    addNumber(verb, "--time", options.time);
    addText(verb, "--animation", options.animation);
    verb.add_flag("--cast-cutouts", options.cutoutsCast)->excludes("--cast-masked");
    addSetting(verb, settings::cull, options.culls);
    addOption(verb, "--ground", [&](const std::string& text) {
        options.ground = groundFromText(text);
        if (!options.ground)
            throw CLI::ValidationError("--ground", "'" + text +
                                                       "' is neither off nor catcher nor a "
                                                       "colour #rrggbb");
    });
    addSectionOptions(verb, options.section);
    addLimitOptions(verb, options.limits);
}

LoadedScene SceneOptions::load(Shading shading, ShadowMethod shadows, bool oppositeVertices) const {
    if (oppositeVertices && culls.value_or(false))
        throw Error(ExitStatus::usage,
                    "--cull auto does not go with --layout published or brute-force, whose records "
                    "don't say which side of a triangle is its front; adapted can.");
    LoadedScene loaded = loadScene(input, casters.wanted(), limits, {}, {variant, shading});
    prepare(loaded, shadows, oppositeVertices);
    return loaded;
}

LoadedScene SceneOptions::loadForRays(Shading shading) const {
    constexpr ShadowMethod exact = ShadowMethod::primitiveMap;
    // Poses and cuts change shadow data, and so need them.
    if (isPosed() || !section.section().planes.empty()) return load(shading, exact, false);
    LoadedScene loaded = loadSurfaces(input, casters.wanted(), limits, {variant, shading});
    prepare(loaded, exact, false);
    return loaded;
}

void SceneOptions::prepare(LoadedScene& loaded, ShadowMethod shadows, bool oppositeVertices) const {
    loaded.cutoutsCast = cutoutsCast;
    loaded.scene.culls = culls.value_or(cullsByDefault && !oppositeVertices);
    if (cutoutsCast &&
        (shadows == ShadowMethod::volumes || shadows == ShadowMethod::irregularZBuffer))
        loaded.scene.warnings.add("--cast-cutouts: volumes count no cutouts, nor does an irregular "
                                  "z-buffer; --shadows "
                                  "primitive-map has them, exactly, auto, and map.");
    if (isPosed() && !poseScene(loaded, time.value_or(0.0), animation) && animation.empty())
        loaded.scene.warnings.add("--time: the scene has no animation that moves anything, so it "
                                  "is at rest.");
    leaveOutHidden(loaded);
    if (const GroundChoice asked = typedGround()) addGround(loaded, *asked);
    cutScene(loaded, section.section());
    if (const SunOptions& sun = view.lights.sun; sun.isDown())
        loaded.scene.warnings.add(sun.downSentence() + ", so it lights nothing.");
}

nlohmann::ordered_json SceneOptions::sceneJson(const Scene& scene) const {
    nlohmann::ordered_json json = {{"ground", textOf(typedGround())},
                                   {"cast-cutouts", cutoutsCast},
                                   {"cull", wordOf(settings::cull.domain, scene.culls)}};
    if (scene.cutFrom) json["section"] = viewer::toJson(std::optional(scene.cutFrom->section));
    if (time) json["time"] = *time;
    if (!animation.empty()) json["animation"] = animation;
    if (view.lights.sun.typed()) json["sun"] = view.lights.sun.json();
    return json;
}

std::string glLimitsName(gl::Limits limits) {
    return optionOf("", "--gl-limits").values.words.at(limits == gl::Limits::es2Minimum);
}

Camera cameraFor(const ViewOptions& options, const Scene& scene) {
    const Camera framing = framingCamera(scene, options.fovDegrees, options.aspect());
    const Camera camera{options.from.value_or(framing.from), options.to.value_or(framing.to),
                        options.fovDegrees};
    if (camera.from == camera.to)
        throw Error(ExitStatus::usage,
                    "--camera-from and --camera-to are the same point, so the camera has no "
                    "direction.");
    return camera;
}

const SceneCamera* fileCameraFor(const ViewOptions& options, const Scene& scene) {
    if (!options.camera) return nullptr;
    if (const SceneCamera* found = findCamera(scene.cameras, *options.camera)) return found;
    std::string all;
    for (std::size_t i = 0; i < scene.cameras.size(); ++i)
        all += (i == 0 ? "it has " : ", ") + std::to_string(i) + " '" + titleOf(scene.cameras, i) +
               "'";
    throw Error(ExitStatus::usage, "--camera: the file has no camera '" + *options.camera + "'; " +
                                       (all.empty() ? "it has none" : all) + ".");
}

std::vector<Light> lightsFor(const LightOptions& options, const Scene& scene) {
    std::vector<Light> lights = options.all();
    if (lights.empty() && options.choice != LightChoice::fallback) lights = lightsOf(scene);
    if (lights.empty()) lights.push_back(defaultLight());
    options.extents.giveTo(lights);
    return lights;
}

FrameRequest requestFor(const ViewOptions& options, const Scene& scene) {
    FrameRequest request;
    if (const SceneCamera* camera = fileCameraFor(options, scene))
        request.frustum = frustumOf(*camera, options.aspect());
    else
        request.frustum =
            frustumOf(cameraFor(options, scene), options.aspect(), options.orthoHeight);
    if (options.cameraMatrix) request.frustum.viewFromWorld = *options.cameraMatrix;
    if (request.frustum.orthographic && options.depth.near)
        throw Error(ExitStatus::usage,
                    std::string("--near does not go with ") +
                        (options.camera ? "an orthographic --camera" : "--ortho") +
                        ", whose picture shows all that there is before and behind the camera.");
    request.width = options.width;
    request.height = options.height;
    request.depth = options.depth;
    request.lights = lightsFor(options.lights, scene);
    return request;
}

} // namespace edgeshade::cli
