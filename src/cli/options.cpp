#include "src/cli/options.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/scene/animation.hpp"
#include "src/cli/limit_options.hpp"
#include "src/cli/number_text.hpp"
#include "src/scene/pose.hpp"
#include "src/shadow/lights/scene_lights.hpp"
#include "src/shadow/view/framing.hpp"
#include "src/shadow/view/scene_cameras.hpp"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <glm/gtc/type_ptr.hpp>
#include <tuple>

namespace edgeshade::cli {
namespace {

/// Parses a matrix column by column.
glm::dmat4 matrixFrom(const std::string& text, const std::string& option) {
    return glm::make_mat4(numbersFrom<16>(text, option, "16 numbers with commas").data());
}

const Choices<gl::Limits> limitNames = {{"device", gl::Limits::device},
                                        {"es2-minimum", gl::Limits::es2Minimum}};

const Choices<InstanceChoice> instanceNames = {{"auto", InstanceChoice::automatic},
                                               {"shared", InstanceChoice::shared},
                                               {"repeated", InstanceChoice::repeated}};

template <class Use>
void addTextOption(CLI::App& verb, const std::string& name, const std::string& type,
                   const std::string& help, Use use) {
    verb.add_option_function<std::string>(name, use, help)->type_name(type);
}

void addViewOptions(CLI::App& verb, ViewOptions& options) {
    addTextOption(verb, "--size", "WxH",
                  "Picture size in pixels (" + std::to_string(options.width) + "x" +
                      std::to_string(options.height) + ")",
                  [&](const std::string& text) {
                      std::tie(options.width, options.height) = sizeFrom(text, "--size");
                  });
    addTextOption(
        verb, "--camera-from", "X,Y,Z", "Where the eye is (frames the scene)",
        [&](const std::string& text) { options.from = vectorFrom(text, "--camera-from"); });
    addTextOption(verb, "--camera-to", "X,Y,Z", "What the eye looks at (middle of the scene)",
                  [&](const std::string& text) { options.to = vectorFrom(text, "--camera-to"); });
    addTextOption(verb, "--camera-matrix", "M0,...,M15",
                  "A view matrix, world to camera, column by column, in place of both",
                  [&](const std::string& text) {
                      options.cameraMatrix = rigidView(matrixFrom(text, "--camera-matrix"));
                  });
    for (const char* other : {"--camera-from", "--camera-to"})
        verb.get_option("--camera-matrix")->excludes(verb.get_option(other));
    addTextOption(verb, "--ortho", "HEIGHT",
                  "An orthographic picture, so many scene units high (perspective)",
                  [&](const std::string& text) {
                      options.orthoHeight = numberFrom(text, "--ortho");
                      if (*options.orthoHeight <= 0.0)
                          throw CLI::ValidationError("--ortho", "'" + text + "' is not above 0");
                  });
    addTextOption(verb, "--fov", "DEG", "Vertical field of view in degrees (45)",
                  [&](const std::string& text) {
                      options.fovDegrees = numberFrom(text, "--fov");
                      if (options.fovDegrees <= 0.0 || options.fovDegrees >= 180.0)
                          throw CLI::ValidationError("--fov",
                                                     "'" + text + "' is not between 0 and 180");
                  });
    verb.add_option("--camera", options.camera,
                    "One of the file's cameras: its name, its node's, or its index among those "
                    "that the scene's nodes place, from 0; info lists them. It sees its own height "
                    "at the picture's aspect")
        ->type_name("NAME|INDEX");
    for (const char* other :
         {"--camera-from", "--camera-to", "--camera-matrix", "--ortho", "--fov"})
        verb.get_option("--camera")->excludes(verb.get_option(other));
    addTextOption(verb, "--near", "D|auto",
                  "Distance of the near plane; auto: as far out as what is visible allows (auto)",
                  [&](const std::string& text) {
                      if (text == "auto") return options.depth.near.reset();
                      options.depth.near = numberFrom(text, "--near");
                      if (*options.depth.near <= 0.0)
                          throw CLI::ValidationError("--near", "'" + text + "' is not above 0");
                  });
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

CLI::Validator finite() {
    return CLI::Validator(
        [](const std::string& text) {
            return std::isfinite(std::strtod(text.c_str(), nullptr)) ? std::string()
                                                                     : text + " is not finite";
        },
        "");
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
    const auto number = [](const std::string& text, const std::string& name, double end) {
        const double value = numberFrom(text, name);
        if (value < 0.0) throw CLI::ValidationError(name, "'" + text + "' is below 0");
        if (value >= end)
            throw CLI::ValidationError(name, "'" + text + "' is not below " +
                                                 std::to_string(static_cast<int>(end)));
        return value;
    };
    const auto add = [&](const std::string& name, const std::string& type,
                         std::optional<double>& value, double end, const std::string& help) {
        addTextOption(verb, name, type, help, [&value, name, end, number](const std::string& text) {
            value = number(text, name, end);
        });
    };
    addTextOption(
        verb, "--weld-tolerance", "D|auto",
        "Vertices closer than this, in scene units, become one (0: only equal ones; auto: "
        "as much as closes most borders, up to 0.01 % of the scene's diagonal)",
        [&changes, number](const std::string& text) {
            changes.autoWeld = text == "auto";
            changes.weldTolerance.reset();
            if (!changes.autoWeld)
                changes.weldTolerance = number(text, "--weld-tolerance", INFINITY);
        });
    add("--flat-tolerance", "DEG", changes.flatTolerance, flatToleranceEnd,
        "Edges that bend no more than this, in degrees, are taken for flat and cast nothing; of "
        "plane-pair records (0: exactly flat ones)");
    add("--caster-error", "D", changes.casterError, INFINITY,
        "Shadow volumes are those of simplified casters, about this far off, in scene units; what "
        "is drawn stays as it is (0: not simplified)");
    addChoice(verb, "--instances", changes.instances, instanceNames,
              "Meshes that stand at several places are kept once (shared), again for each place "
              "(repeated), or once where that pays (auto)");
}

void addCasterOptions(CLI::App& verb, CasterOptions& options) {
    addCasterChanges(verb, options.changes);
    verb.add_flag_callback(
        "--cast-masked", [&] { options.castMasked = true; },
        "MASK and BLEND surfaces cast shadows too, of their whole triangles");
}

void addSamplesOption(CLI::App& verb, int& samples) {
    verb.add_option("--samples", samples, "Samples a pixel for antialiasing (0: none)")
        ->check(CLI::Range(0, 64))
        ->type_name("N");
}

void addSceneOptions(CLI::App& verb, SceneOptions& options) {
    addUnlitSceneOptions(verb, options);
    addLightOptions(verb, options.view.lights);
}

void addUnlitSceneOptions(CLI::App& verb, SceneOptions& options) {
    addViewOptions(verb, options.view);
    addCasterOptions(verb, options.casters);
    addChoice(verb, "--gl-limits", options.glLimits, limitNames,
              "What is used of the GL: all that the device has, or only what every OpenGL ES 2.0 "
              "has: no extensions, 8 attributes, 16 bits of depth (device)");
    verb.add_option("--variant", options.variant,
                    "Which of the scene's variants of materials is drawn; info lists them (the "
                    "scene's own materials)")
        ->type_name("NAME");
    addTextOption(verb, "--time", "S",
                  "Nodes, cameras and lights are where the file's animation has them after so many "
                  "seconds, skins and morph targets too (at rest; with --animation and of view, 0)",
                  [&](const std::string& text) {
                      options.time = numberFrom(text, "--time");
                      if (*options.time < 0.0 || *options.time > longestTime)
                          throw CLI::ValidationError("--time",
                                                     "'" + text + "' is not between 0 and 1e9");
                  });
    verb.add_option("--animation", options.animation,
                    "Which of the file's animations (the first); info lists them")
        ->type_name("NAME|INDEX");
    verb.add_flag("--cast-cutouts", options.cutoutsCast,
                  "MASK surfaces cast the shadow of what their alpha leaves, wherever shadow is "
                  "looked up: in primitive maps, exactly, and in shadow maps; volumes count none "
                  "of it")
        ->excludes("--cast-masked");
    addChoice(verb, "--cull", options.culls, cullNames,
              "auto: surfaces of materials that aren't double-sided are seen from their front "
              "alone, and cast from either side; off: all are seen from both sides. auto does not "
              "go with --layout published or brute-force (" +
                  std::string(cullsByDefault ? "auto" : "off") + ")");
    verb.add_option_function<std::string>(
            "--ground",
            [&](const std::string& text) {
                options.ground = groundFromText(text);
                if (!options.ground)
                    throw CLI::ValidationError("--ground", "'" + text +
                                                               "' is neither off nor catcher nor a "
                                                               "colour #rrggbb");
            },
            "A plane just beneath the scene, seen from above: one that catches shadow and shows "
            "nothing else, or one of a colour (off; of view, catcher where the scene has no floor)")
        ->type_name("off|catcher|#RRGGBB");
    addLimitOptions(verb, options.limits);
}

LoadedScene SceneOptions::load(Shading shading, ShadowMethod shadows, bool oppositeVertices) const {
    if (oppositeVertices && culls.value_or(false))
        throw Error(ExitStatus::usage,
                    "--cull auto does not go with --layout published or brute-force, whose records "
                    "don't say which side of a triangle is its front; adapted can.");
    LoadedScene loaded = loadScene(input, casters.wanted(), limits, {}, {variant, shading});
    loaded.cutoutsCast = cutoutsCast;
    loaded.scene.culls = culls.value_or(cullsByDefault && !oppositeVertices);
    if (cutoutsCast &&
        (shadows == ShadowMethod::volumes || shadows == ShadowMethod::irregularZBuffer))
        loaded.scene.warnings.add("--cast-cutouts: volumes count no cutouts, nor does an irregular "
                                  "z-buffer; --shadows "
                                  "primitive-map has them, exactly, auto, and map.");
    const bool wanted = time || !animation.empty();
    if (wanted && !poseScene(loaded, time.value_or(0.0), animation) && animation.empty())
        loaded.scene.warnings.add("--time: the scene has no animation that moves anything, so it "
                                  "is at rest.");
    leaveOutHidden(loaded);
    if (const GroundChoice asked = typedGround()) addGround(loaded, *asked);
    if (const SunOptions& sun = view.lights.sun; sun.isDown())
        loaded.scene.warnings.add(sun.downSentence() + ", so it lights nothing.");
    return loaded;
}

nlohmann::ordered_json SceneOptions::sceneJson(const Scene& scene) const {
    nlohmann::ordered_json json = {{"ground", textOf(typedGround())},
                                   {"cast-cutouts", cutoutsCast},
                                   {"cull", scene.culls ? "auto" : "off"}};
    if (time) json["time"] = *time;
    if (!animation.empty()) json["animation"] = animation;
    if (view.lights.sun.typed()) json["sun"] = view.lights.sun.json();
    return json;
}

std::string glLimitsName(gl::Limits limits) {
    for (const auto& [name, value] : limitNames)
        if (value == limits) return name;
    return "";
}

void addReportOption(CLI::App& verb, std::string& path) {
    verb.add_option("--report", path, "Write a JSON report to this file; - is standard output")
        ->type_name("FILE");
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
