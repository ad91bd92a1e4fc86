#include "src/cli/commands.hpp"

#include "preprocess/base/error.hpp"

#ifdef EDGESHADE_HAS_WINDOW
#include "preprocess/reading/animation_reading.hpp"
#include "src/cli/draw_settings.hpp"
#include "src/cli/options.hpp"
#include "src/cli/report.hpp"
#include "src/desktop/app.hpp"
#include "src/scene/pose.hpp"
#include "src/shadow/view/light_budget.hpp"
#include "src/shadow/view/scene_cameras.hpp"
#include "src/viewer/section_state.hpp"

#include <memory>
#endif

namespace edgeshade::cli {
#ifdef EDGESHADE_HAS_WINDOW
namespace {

using Json = nlohmann::ordered_json;

struct WindowOptions : SceneOptions {
    std::string screenshot;
    DrawSettings settings;
    int samples{};
    std::size_t smooth{};
    bool sunHours = false;
    int sunHoursStep{}; ///< minutes
};

/// An upright camera, from which the user can go on: it drops any roll.
Camera cameraOfMatrix(const ViewOptions& options, const Scene& scene) {
    SceneCamera camera;
    camera.worldFromCamera = glm::inverse(*options.cameraMatrix);
    camera.height = glm::radians(options.fovDegrees);
    return uprightCamera(camera, worldBounds(scene));
}

/// Places the scene as typed. Returns the index of its animation in the view's state.
std::optional<std::size_t> placeAsTyped(const WindowOptions& options, LoadedScene& loaded) {
    if (!options.time && options.animation.empty()) return std::nullopt;
    const std::size_t known = loaded.scene.warnings.sentences().size();
    placeAt(loaded, options.time.value_or(0.0), options.animation);
    const std::vector<std::string>& warnings = loaded.scene.warnings.sentences();
    printWarnings({warnings.begin() + static_cast<std::ptrdiff_t>(known), warnings.end()});
    const std::vector<AnimationTitle> titles = animationTitles(*loaded.document);
    const AnimationTitle* const found = findAnimation(titles, options.animation);
    if (!found) return std::nullopt;
    return static_cast<std::size_t>(found - titles.data());
}

/// The view's state: camera, lights and the left side, as typed.
Json stateFrom(const WindowOptions& options, const Scene& scene,
               const std::optional<std::size_t>& animation) {
    const FrameRequest request = requestFor(options.view, scene);
    const RenderSettings& render = options.settings.render;
    viewer::ViewState state;
    const SceneCamera* const ofFile = fileCameraFor(options.view, scene);
    if (ofFile && ofFile->orthographic)
        throw Error(ExitStatus::usage, "--camera " + *options.view.camera +
                                           " is orthographic, but the window's camera is in "
                                           "perspective; render, compare and bench show it.");
    if (ofFile)
        state.camera = uprightCamera(*ofFile, worldBounds(scene));
    else
        state.camera = options.view.cameraMatrix ? cameraOfMatrix(options.view, scene)
                                                 : cameraFor(options.view, scene);
    state.lights = request.lights;
    state.lightSamples = render.lightSamples;
    requireExtents(options.settings, state.lights);
    requireMapKind(options.settings, state.lights);
    setSide(state.left, render);
    state.shading = render.shading;
    state.ambient = render.ambient;
    state.exposure = render.exposure;
    const Json all = viewer::toJson(state);
    Json typed;
    for (const char* key :
         {"camera", "lights", "light_samples", "shading", "ambient", "exposure", "left"})
        typed[key] = all[key];
    if (const SunOptions& sun = options.view.lights.sun; sun.typed()) {
        typed["sun"] =
            viewer::toJson(std::optional(viewer::SunState{*sun.place, *sun.time, sun.north}));
        if (sun.isDown()) printWarnings({sun.downSentence() + ", so it lights nothing."});
    }
    typed["smooth"] = options.smooth;
    if (options.sunHours) {
        typed["sun_hours"] = true;
        typed["sun_hours_step"] = options.sunHoursStep;
    }
    if (options.ground) typed["ground"] = textOf(*options.ground);
    if (const Section section = options.section.section(); !section.planes.empty())
        typed["section"] = viewer::toJson(std::optional(section));
    if (options.time) typed["time"] = *options.time;
    if (animation) typed["animation"] = *animation;
    return typed;
}

void view(const WindowOptions& options) {
    if (options.culls.value_or(false) && drawOppositeVertices(std::array{options.settings}))
        throw Error(ExitStatus::usage,
                    "--cull auto does not go with --layout published or brute-force.");
    if (options.view.orthoHeight)
        throw Error(ExitStatus::usage, "The window's camera is in perspective: --ortho is for "
                                       "render, compare and bench.");
    const auto load = [&](const std::filesystem::path& path, const std::string& variant) {
        LoadedScene loaded =
            loadScene(path, options.casters.wanted(), options.limits, {}, {variant});
        loaded.cutoutsCast = options.cutoutsCast;
        loaded.scene.culls = options.culls.value_or(cullsByDefault);
        printWarnings(loaded.scene.warnings.sentences());
        return loaded;
    };
    std::optional<LoadedScene> loaded;
    Json state;
    if (!options.input.empty()) {
        loaded = load(options.input, options.variant);
        // Place the scene first: its cameras and lights move with it.
        const auto animation = placeAsTyped(options, *loaded);
        state = stateFrom(options, loaded->scene, animation);
    }

    viewer::ViewerSettings settings;
    settings.render = options.settings.render;
    settings.chooseLights = chooseLights;
    settings.depth = options.view.depth;
    settings.depth.slices = options.settings.depthSlices;
    if (options.settings.instancing != InstancingChoice::automatic)
        settings.layout = layoutFor(options.settings.instancing, {});
    const std::string name = std::filesystem::path(options.input).filename().string();
    desktop::App app({name.empty() ? "edgeshade" : name + " - edgeshade", options.view.width,
                      options.view.height, options.samples, options.glLimits},
                     settings, load);
    if (loaded) {
        app.show(options.input, std::move(*loaded));
        app.viewer().change(state);
    }
    if (options.screenshot.empty()) {
        app.run();
    } else {
        app.settle();
        app.saveScreenshot(options.screenshot);
    }
}

} // namespace

void addViewCommand(CLI::App& program) {
    CLI::App* verb =
        program.add_subcommand("view", "Show a scene in a window; its key H lists the keys");
    const auto options = std::make_shared<WindowOptions>();
    addSceneFile(*verb, *options);
    addText(*verb, "--screenshot", options->screenshot)->needs(verb->get_option("FILE"));
    addSceneOptions(*verb, *options);
    addDrawOptions(*verb, options->settings);
    addNumber(*verb, "--samples", options->samples);
    addSetting(*verb, settings::smooth, options->smooth);
    CLI::Option* const sunHours = verb->add_flag("--sun-hours", options->sunHours);
    sunHours->needs(verb->get_option("--place"));
    addNumber(*verb, "--step", options->sunHoursStep)->needs(sunHours);
    verb->callback([options] {
        resolve(options->settings);
        view(*options);
    });
}
#else
void addViewCommand(CLI::App& program) {
    CLI::App* verb = program.add_subcommand("view", "Show a scene in a window (not built in)");
    verb->prefix_command();
    verb->callback([] {
        throw Error(ExitStatus::unavailable,
                    "This program was built without GLFW, so it has no 'view'.");
    });
}
#endif

} // namespace edgeshade::cli
