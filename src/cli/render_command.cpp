#include "preprocess/base/error.hpp"
#include "preprocess/base/stopwatch.hpp"
#include "src/cli/commands.hpp"
#include "src/cli/draw_settings.hpp"
#include "src/cli/explanation.hpp"
#include "src/cli/options.hpp"
#include "src/cli/report.hpp"
#include "src/cli/still.hpp"
#include "src/gl/headless_context.hpp"
#include "src/image/png.hpp"
#include "src/render/accumulation/extended_lights.hpp"
#include "src/render/frame/light_methods.hpp"
#include "src/render/frame/prepare_scene.hpp"
#include "src/render/frame/volume_tint_pass.hpp"
#include "src/scene/pose.hpp"
#include "src/scene/shadow_facts.hpp"
#include "src/shadow/view/scene_cameras.hpp"
#include "src/viewer/light_state.hpp"

#include <algorithm>
#include <glm/gtc/type_ptr.hpp>
#include <memory>

namespace edgeshade::cli {
namespace {

enum class DebugPicture { none, volumes, primitiveMap };

struct RenderOptions : SceneOptions {
    std::string output;
    std::string report;
    DrawSettings settings;
    bool mask = false;
    bool explain = false;
    DebugPicture debug = DebugPicture::none;
    int samples{};
    std::size_t subpixels{};
    bool shadeSamples = false;
};

/// Numbers of pixels of a mask that show a surface, and a surface that some light reaches.
std::pair<std::size_t, std::size_t> countMask(const std::vector<std::uint8_t>& rgba) {
    std::size_t visible = 0, lit = 0;
    for (std::size_t i = 0; i < rgba.size(); i += 4) {
        visible += rgba[i + 3] != 0;
        lit += rgba[i] != 0;
    }
    return {visible, lit};
}

nlohmann::ordered_json vectorJson(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

/// The picture's camera: as typed, and as resolved.
nlohmann::ordered_json cameraJson(const ViewOptions& options, const Scene& scene,
                                  const FrameView& view) {
    nlohmann::ordered_json camera;
    const auto setMatrix = [&](const glm::dmat4& viewFromWorld) {
        camera["matrix"] =
            std::vector<double>(glm::value_ptr(viewFromWorld), glm::value_ptr(viewFromWorld) + 16);
    };
    if (const SceneCamera* typed = fileCameraFor(options, scene)) {
        camera["name"] = typed->name;
        camera["node"] = typed->nodeName;
        setMatrix(frustumOf(*typed, options.aspect()).viewFromWorld);
        if (typed->orthographic)
            camera["ortho"] = typed->height;
        else
            camera["fov"] = glm::degrees(typed->height);
        camera["near"] = view.near();
        return camera;
    }
    if (options.cameraMatrix) {
        setMatrix(*options.cameraMatrix);
    } else {
        const Camera typed = cameraFor(options, scene);
        camera["from"] = vectorJson(typed.from);
        camera["to"] = vectorJson(typed.to);
    }
    if (options.orthoHeight)
        camera["ortho"] = *options.orthoHeight;
    else
        camera["fov"] = options.fovDegrees;
    camera["near"] = view.near();
    return camera;
}

/// Depth slices from near to far, and the number of groups of casters for each light.
nlohmann::ordered_json planJson(const FrameView& view) {
    nlohmann::ordered_json slices = nlohmann::ordered_json::array();
    for (auto slice = view.slices.rbegin(); slice != view.slices.rend(); ++slice)
        slices.push_back(slice->near);
    nlohmann::ordered_json groups = nlohmann::ordered_json::array();
    for (const FrameLight& of : view.lights)
        groups.push_back(of.groupCount());
    return {{"slice_near_planes", slices}, {"caster_groups", groups}};
}

/// Warnings about shadows that the picture may lack.
std::vector<std::string> warningsOf(const FrameView& view) {
    std::vector<std::string> warnings;
    for (std::size_t i = 0; i < view.lights.size(); ++i)
        if (view.lights[i].layers.mayOverflow)
            warnings.push_back(
                "Light " + std::to_string(i) + ": up to " +
                std::to_string(view.lights[i].layers.most) +
                " triangles may lie behind each other, too many to count in groups; "
                "points in the shadow of exactly 256 or 512 of them would appear lit.");
    return warnings;
}

/// Tints the picture by all lights' volumes.
void tintVolumes(GpuScene& scene, const FrameView& view, const Renderer& renderer,
                 const gl::Capabilities& capabilities) {
    VolumeTintPass tint(renderer.settings(), capabilities);
    for (std::size_t light = 0; light < view.lights.size(); ++light)
        tint.draw(scene, view, renderer.plan(), light);
}

nlohmann::ordered_json pointsJson(const std::vector<Light>& points) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const Light& point : points) {
        const glm::dvec4& at = point.position;
        json.push_back({at.x, at.y, at.z, at.w});
    }
    return json;
}

/// The points of the first light with an extent.
nlohmann::ordered_json lightSamplesJson(const FrameView& view) {
    for (const FrameLight& of : view.lights)
        if (!of.points.empty()) return pointsJson(of.points);
    return nlohmann::ordered_json::array();
}

void requireFitting(const RenderOptions& options, const std::vector<Light>& lights) {
    requireExtents(options.settings, lights);
    requireMapKind(options.settings, lights);
    const std::string option = extentOption(options.settings);
    if (options.settings.render.countedPoints() == 0 && !option.empty())
        throw Error(ExitStatus::usage, option + " does not go with --soft, which samples one "
                                                "map from the light's centre.");
    const bool extended = options.view.lights.extents.typed();
    if ((extended || options.subpixels > 1) && options.debug == DebugPicture::volumes)
        throw Error(ExitStatus::usage, "--debug volumes shows the volumes of lights without an "
                                       "extent in one picture, not in a sum of pictures.");
    if (extended && options.samples > 0)
        throw Error(ExitStatus::usage, "--samples does not go with lights that have an extent; "
                                       "--smooth does.");
}

void render(const RenderOptions& options) {
    Stopwatch watch;
    LoadedScene loaded =
        options.load(options.settings.render.shading, options.settings.render.shadows,
                     drawOppositeVertices(std::array{options.settings}));
    if (options.settings.render.shadows == ShadowMethod::primitiveMap) holdStill(loaded.scene);
    std::vector<std::string> warnings = loaded.scene.warnings.sentences();
    printWarnings(warnings);
    StillTask task{.request = requestFor(options.view, loaded.scene),
                   .subpixels = options.subpixels,
                   .mask = options.mask,
                   .shadeSamples = options.shadeSamples,
                   .firstIsDown = options.view.lights.sun.isDown(),
                   .shadowedLights = options.settings.render.shadowedLights};
    task.request.depth.slices = options.settings.depthSlices;
    task.request.lightSamples = options.settings.render.countedPoints();
    requireFitting(options, task.request.lights);
    const SceneTree tree(loaded.scene);
    FrameView view = viewOf(loaded, tree, task, 0);
    const gl::HeadlessContext context({view.width, view.height, options.samples, options.glLimits});
    const gl::Capabilities& capabilities = context.capabilities();
    RenderSettings settings = options.settings.render;
    settings.layout = layoutFor(options.settings.instancing, capabilities);
    Renderer renderer(settings, capabilities);
    GpuScene scene = uploadScene(loaded, settings.records(), capabilities);
    const double loadSeconds = watch.lap();
    makeLookups(scene, loaded, view, renderer);
    boundCountedLayers(view, loaded, scene, renderer.policyFor(sceneFactsOf(scene)),
                       options.shadeSamples);
    const std::vector<std::string> more = warningsOf(view);
    printWarnings(more);
    warnings.insert(warnings.end(), more.begin(), more.end());

    task.prepared = [&] {
        const std::vector<std::string> others =
            fallbackWarnings(settings.shadows, lightMethods(scene, view, renderer));
        printWarnings(others);
        warnings.insert(warnings.end(), others.begin(), others.end());
    };
    ProgressBar bar;
    const bool slow = options.subpixels > 1 || ExtendedLights::points(view) > 0;
    std::vector<std::uint8_t> pixels =
        drawStill(loaded, tree, task, view, renderer, scene, context, [&](double share) {
            if (slow) bar.show(share, "drawing");
        });
    if (options.debug == DebugPicture::volumes) {
        tintVolumes(scene, view, renderer, capabilities);
        gl::requireNoError("drawing volumes");
        pixels = context.readPixels();
    }
    const double drawSeconds = watch.lap();
    writeFile(options.output, encodePng(pixels, view.width, view.height));
    if (options.explain || options.debug != DebugPicture::none)
        printResult(explanationOf(renderer, scene, view), options.report);
    printResult(options.output + ": " + std::to_string(view.width) + "x" +
                    std::to_string(view.height) + ", " +
                    std::to_string(loaded.scene.triangleCount()) + " triangles, drawn by " +
                    capabilities.renderer,
                options.report);

    const std::vector<LightMethod> methods = lightMethods(scene, view, renderer);
    nlohmann::ordered_json lights = methodsJson(methods);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const Light& light = view.lights[i].light;
        lights[i]["position"] = {light.position.x, light.position.y, light.position.z,
                                 light.position.w};
        const auto named = viewer::namedJson(light);
        for (const char* key : {"color", "intensity", "range", "cone"})
            if (named.contains(key)) lights[i][key] = named[key];
    }
    nlohmann::ordered_json report = {
        {"size", {view.width, view.height}},
        {"camera", cameraJson(options.view, loaded.scene, view)},
        {"lights", lights},
        {"settings", settingsJson(options.settings)},
        {"plan", planJson(view)},
        {"device", deviceJson(capabilities)},
        {"bytes_gpu", scene.shadowBytes() + scene.primitiveMaps.bytes() + renderer.bytes()},
        {"seconds", {{"load", loadSeconds}, {"draw", drawSeconds}}},
        {"warnings", warnings},
    };
    if (const auto points = lightSamplesJson(view); !points.empty())
        report["light_samples"] = points;
    report["settings"].update({{"samples", capabilities.samples},
                               {"smooth", options.subpixels},
                               {"shade-samples", options.shadeSamples},
                               {"mask", options.mask}});
    report["settings"].update(options.sceneJson(loaded.scene));
    if (options.mask) {
        const auto [visible, lit] = countMask(pixels);
        report["visible_pixels"] = visible;
        report["lit_pixels"] = lit;
    }
    writeReport(report, options.report);
}

} // namespace

void addRenderCommand(CLI::App& program) {
    CLI::App* verb =
        program.add_subcommand("render", "Draw one picture of a scene, without a display");
    const auto options = std::make_shared<RenderOptions>();
    addSceneFile(*verb, *options)->required();
    verb->add_option("OUT", options->output, "The picture, .png")->required();
    verb->add_flag("--mask", options->mask);
    addSetting(*verb, settings::smooth, options->subpixels);
    verb->add_flag("--shade-samples", options->shadeSamples);
    verb->add_flag("--explain", options->explain);
    addWords(*verb, "--debug", options->debug,
             std::vector{DebugPicture::none, DebugPicture::volumes, DebugPicture::primitiveMap});
    addSceneOptions(*verb, *options);
    addDrawOptions(*verb, options->settings);
    addNumber(*verb, "--samples", options->samples);
    addText(*verb, "--report", options->report);
    verb->callback([options] {
        resolve(options->settings);
        if (options->shadeSamples) options->settings.typed.insert("--shade-samples");
        RenderSettings& drawn = options->settings.render;
        drawn.tintPrimitives = options->debug == DebugPicture::primitiveMap;
        if (drawn.tintPrimitives && (options->mask || !drawn.looksUpPrimitives()))
            throw Error(ExitStatus::usage, "--debug primitive-map needs --shadows primitive-map or "
                                           "auto, and a picture, not a --mask.");
        if (options->debug == DebugPicture::volumes &&
            (options->mask || drawn.shadows != ShadowMethod::volumes))
            throw Error(ExitStatus::usage,
                        "--debug volumes needs --shadows volumes, and a picture, not a --mask.");
        render(*options);
    });
}

} // namespace edgeshade::cli
