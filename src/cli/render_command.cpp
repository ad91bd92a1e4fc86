#include "preprocess/error.hpp"
#include "preprocess/stopwatch.hpp"
#include "src/cli/commands.hpp"
#include "src/cli/options.hpp"
#include "src/cli/report.hpp"
#include "src/gl/headless_context.hpp"
#include "src/image/png.hpp"

#include <cmath>
#include <cstdlib>
#include <map>
#include <memory>

namespace edgeshade::cli {
namespace {

enum class InstancingChoice { automatic, on, off, multiDraw };

struct RenderOptions {
    std::string input;
    std::string output;
    std::string report;
    ViewOptions view;
    CasterOptions casters;
    RenderSettings settings;
    InstancingChoice instancing = InstancingChoice::automatic;
    int samples = 0;
    std::vector<std::string> mapOptions; ///< those typed that only shadow maps have
};

const std::map<std::string, ShadowMethod> shadowNames = {
    {"volumes", ShadowMethod::volumes}, {"map", ShadowMethod::map}, {"none", ShadowMethod::none}};
const std::map<std::string, MultiplicityMethod> multiplicityNames = {
    {"reference-edge", MultiplicityMethod::referenceEdge},
    {"three-edge", MultiplicityMethod::threeEdge},
    {"single-edge", MultiplicityMethod::singleEdge}};
const std::map<std::string, InstancingChoice> instancingNames = {
    {"on", InstancingChoice::on},
    {"off", InstancingChoice::off},
    {"multi-draw", InstancingChoice::multiDraw}};

template <class Value>
std::string nameIn(const std::map<std::string, Value>& names, Value value) {
    for (const auto& [name, candidate] : names)
        if (candidate == value) return name;
    return "auto";
}

template <class Value>
void addChoice(CLI::App& verb, const std::string& option, Value& value,
               const std::map<std::string, Value>& names, const std::string& type,
               const std::string& help) {
    verb.add_option(option, value, help)
        ->type_name(type)
        ->transform(CLI::CheckedTransformer(names).description(""));
}

/// Adds an option that only shadow maps have.
template <class Value>
CLI::Option* addMapOption(CLI::App& verb, RenderOptions& options, const std::string& name,
                          Value& value, const std::string& help) {
    return verb.add_option_function<Value>(
        name,
        [&options, &value, name](const Value& typed) {
            value = typed;
            options.mapOptions.push_back(name);
        },
        help);
}

void addMapOptions(CLI::App& verb, RenderOptions& options) {
    ShadowMapSettings& map = options.settings.map;
    addMapOption(verb, options, "--map-size", map.size,
                 "Texels along an edge of a shadow map, of each of a point light's six (2048)")
        ->check(CLI::Range(16, 16384))
        ->type_name("N");
    const CLI::Validator finite(
        [](const std::string& text) {
            // Range lets what is no number through.
            return std::isfinite(std::strtod(text.c_str(), nullptr)) ? std::string()
                                                                     : text + " is not finite";
        },
        "");
    addMapOption(verb, options, "--map-bias", map.biasTexels,
                 "How far receivers are moved towards the light, in texels as large as they are "
                 "there (1.5)")
        ->check(finite)
        ->check(CLI::Range(0.0, 100.0))
        ->type_name("TEXELS");
    addMapOption(verb, options, "--pcf", map.pcf,
                 "Texels that are compared, N x N: 1, 3, 5 or 7 (1: hard edges)")
        ->check(CLI::IsMember({1, 3, 5, 7}))
        ->type_name("N");
}

SidesLayout layoutFor(InstancingChoice choice, const gl::Capabilities& capabilities) {
    switch (choice) {
    case InstancingChoice::on:
        return SidesLayout::instanced;
    case InstancingChoice::multiDraw:
        return SidesLayout::multiDraw;
    case InstancingChoice::off:
        return SidesLayout::notInstanced;
    default:
        return bestLayout(capabilities);
    }
}

/// Pixels of a mask: surface, and lit surface.
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

nlohmann::ordered_json reportOf(const RenderOptions& options, const FrameView& view,
                                const gl::Capabilities& capabilities, std::size_t bytesGpu,
                                const std::vector<std::uint8_t>& pixels, double loadSeconds,
                                double drawSeconds, const std::vector<std::string>& warnings) {
    nlohmann::ordered_json lights = nlohmann::ordered_json::array();
    for (const Light& light : view.lights)
        lights.push_back({light.position.x, light.position.y, light.position.z, light.position.w});
    nlohmann::ordered_json report = {
        {"size", {view.width, view.height}},
        {"camera",
         {{"from", vectorJson(view.camera.from)},
          {"to", vectorJson(view.camera.to)},
          {"fov", view.camera.fovDegrees},
          {"near", view.near}}},
        {"lights", lights},
        {"settings",
         {{"shadows", nameIn(shadowNames, options.settings.shadows)},
          {"multiplicity", nameIn(multiplicityNames, options.settings.multiplicity)},
          {"instancing", nameIn(instancingNames, options.instancing)},
          {"samples", capabilities.samples},
          {"ambient", options.settings.ambient},
          {"mask", options.settings.mask}}},
        {"device",
         {{"vendor", capabilities.vendor},
          {"renderer", capabilities.renderer},
          {"version", capabilities.version},
          {"depth_bits", capabilities.depthBits},
          {"stencil_bits", capabilities.stencilBits},
          {"vertex_mantissa_bits", capabilities.vertexHighpMantissaBits}}},
        {"bytes_gpu", bytesGpu},
        {"seconds", {{"load", loadSeconds}, {"draw", drawSeconds}}},
        {"warnings", warnings},
    };
    if (options.settings.shadows == ShadowMethod::map) {
        const ShadowMapSettings& map = options.settings.map;
        report["settings"].update(
            {{"map-size", map.size}, {"map-bias", map.biasTexels}, {"pcf", map.pcf}});
    }
    if (options.settings.mask) {
        const auto [visible, lit] = countMask(pixels);
        report["visible_pixels"] = visible;
        report["lit_pixels"] = lit;
    }
    return report;
}

void render(RenderOptions options) {
    if (options.settings.shadows != ShadowMethod::map && !options.mapOptions.empty())
        throw Error(ExitStatus::usage, options.mapOptions.front() + " needs --shadows map.");
    Stopwatch watch;
    const LoadedScene loaded = loadScene(options.input, options.casters.wanted());
    const auto& warnings = loaded.scene.warnings.sentences();
    printWarnings(warnings);
    FrameView view = viewFor(options.view, loaded.scene);
    view.bounds = worldBounds(loaded.scene);
    const gl::HeadlessContext context({view.width, view.height, options.samples});
    const gl::Capabilities& capabilities = context.capabilities();
    options.settings.layout = layoutFor(options.instancing, capabilities);
    Renderer renderer(options.settings, capabilities);
    const GpuScene scene = uploadScene(loaded, options.settings.layout, capabilities);
    const double loadSeconds = watch.lap();

    renderer.draw(scene, view);
    gl::requireNoError("drawing");
    const std::vector<std::uint8_t> pixels = context.readPixels();
    const double drawSeconds = watch.lap();
    writeFile(options.output, encodePng(pixels, view.width, view.height));
    printResult(options.output + ": " + std::to_string(view.width) + "x" +
                    std::to_string(view.height) + ", " +
                    std::to_string(loaded.scene.triangleCount()) + " triangles, drawn by " +
                    capabilities.renderer,
                options.report);
    writeReport(reportOf(options, view, capabilities, scene.shadowBytes() + renderer.mapBytes(),
                         pixels, loadSeconds, drawSeconds, warnings),
                options.report);
}

} // namespace

void addRenderCommand(CLI::App& program) {
    CLI::App* verb =
        program.add_subcommand("render", "Draw one picture of a scene, without a display");
    const auto options = std::make_shared<RenderOptions>();
    verb->add_option("FILE", options->input, "The scene, .gltf or .glb, packed or not")->required();
    verb->add_option("OUT", options->output, "The picture, .png")->required();
    verb->add_flag("--mask", options->settings.mask,
                   "The lit mask of the first light: white lit, black in shadow, clear where "
                   "nothing is");
    addViewOptions(*verb, options->view);
    addChoice(*verb, "--shadows", options->settings.shadows, shadowNames, "volumes|map|none",
              "How shadows are made (volumes)");
    addMapOptions(*verb, *options);
    addChoice(*verb, "--multiplicity", options->settings.multiplicity, multiplicityNames,
              "reference-edge|three-edge|single-edge",
              "How a triangle's facing is decided (reference-edge); single-edge is not robust");
    addChoice(*verb, "--instancing", options->instancing, instancingNames, "on|off|multi-draw",
              "A record an instance, a copy for every vertex, or one draw a side (on where the "
              "GL can)");
    verb->add_option("--samples", options->samples, "Samples a pixel for antialiasing (0: none)")
        ->check(CLI::Range(0, 64))
        ->type_name("N");
    verb->add_option("--ambient", options->settings.ambient,
                     "Share of ambient light; the lights share the rest (0.35)")
        ->check(CLI::Range(0.0, 1.0))
        ->type_name("0..1");
    addCasterOptions(*verb, options->casters);
    addReportOption(*verb, options->report);
    verb->callback([options] { render(*options); });
}

} // namespace edgeshade::cli
