#include "src/cli/draw_settings.hpp"

#include "preprocess/base/error.hpp"
#include "src/cli/help.hpp"
#include "src/cli/options.hpp"
#include "src/environment/reading.hpp"
#include "src/render/volumes/setting_words.hpp"
#include "src/rivals/planar/largest_planes.hpp"
#include "src/shadow/lights/light_extent.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

namespace edgeshade::cli {
namespace {

/// Words that --shadows takes; `shadowNames` are those in reports.
const Choices<ShadowMethod> shadowWords = {{"auto", ShadowMethod::automatic},
                                           {"volumes", ShadowMethod::volumes},
                                           {"lookup", ShadowMethod::primitiveMap},
                                           {"points", ShadowMethod::irregularZBuffer},
                                           {"map", ShadowMethod::map},
                                           {"planar", ShadowMethod::planar},
                                           {"none", ShadowMethod::none}};
const Choices<ShadowMethod> shadowNames = choicesOf(words::shadows);
const Choices<MultiplicityMethod> multiplicityNames = choicesOf(words::multiplicity);
const Choices<VolumeLayout> layoutNames = {{"adapted", VolumeLayout::planePairs},
                                           {"published", VolumeLayout::oppositeVertices},
                                           {"brute-force", VolumeLayout::triangles}};
const Choices<BruteForceCount> countNames = {{"z-fail", BruteForceCount::zFail},
                                             {"z-pass", BruteForceCount::zPass}};
const Choices<SilhouetteChoice> silhouetteNames = {{"proposed", SilhouetteChoice::proposed},
                                                   {"all", SilhouetteChoice::all}};
const Choices<InstancingChoice> instancingNames = {{"on", InstancingChoice::on},
                                                   {"off", InstancingChoice::off},
                                                   {"multi-draw", InstancingChoice::multiDraw}};

const Choices<Shading> shadingNames = choicesOf(words::shading);
const Choices<SoftShadows> softNames = {
    {"none", SoftShadows::none}, {"pcf", SoftShadows::pcf}, {"pcss", SoftShadows::pcss}};
const Choices<MapKind> mapKindNames = choicesOf(words::mapKind);
const Choices<WarpGrid> warpNames = choicesOf(words::warp);
const Choices<FilterChoice> filterNames = {
    {"none", FilterChoice::none}, {"pcf", FilterChoice::pcf}, {"poisson", FilterChoice::poisson},
    {"vsm", FilterChoice::vsm},   {"esm", FilterChoice::esm}, {"msm", FilterChoice::msm},
    {"pcss", FilterChoice::pcss}};
const Choices<bool> terminatorNames = {{"soft", true}, {"exact", false}};
const Choices<int> maskScaleNames = {{"1", 1}, {"1/2", 2}, {"1/4", 4}};

template <class Value>
std::string nameIn(const Choices<Value>& names, Value value) {
    for (const auto& [name, candidate] : names)
        if (candidate == value) return name;
    return "auto";
}

/// The --filter word for these settings.
FilterChoice filterOf(const ShadowMapSettings& map) {
    switch (map.filter) {
    case MapFilter::poisson:
        return FilterChoice::poisson;
    case MapFilter::variance:
        return FilterChoice::vsm;
    case MapFilter::exponential:
        return FilterChoice::esm;
    case MapFilter::moments:
        return FilterChoice::msm;
    case MapFilter::compare:
        break;
    }
    return map.soft == SoftShadows::pcss ? FilterChoice::pcss
           : map.pcf > 1                 ? FilterChoice::pcf
                                         : FilterChoice::none;
}

/// Records in `typed` that the option was typed, for resolve().
CLI::Option* noted(CLI::Option* option, std::vector<std::string>& typed) {
    return option->each(
        [&typed, name = option->get_name()](const std::string&) { typed.push_back(name); });
}

void addMapOptions(CLI::App& verb, DrawSettings& settings) {
    ShadowMapSettings& map = settings.render.map;
    const auto add = [&](const std::string& name, auto& value, const std::string& help) {
        return noted(verb.add_option(name, value, help), settings.mapOptions);
    };
    add("--map-size", map.size,
        "Texels along an edge of a shadow map, of each of a point light's six (2048)")
        ->check(CLI::Range(16, 16384))
        ->type_name("N");
    add("--map-bias", map.biasTexels,
        "How far receivers are moved towards the light, in texels as large as they are there (1.5)")
        ->check(finite())
        ->check(CLI::Range(0.0, 100.0))
        ->type_name("TEXELS");
    addChoice(verb, "--map-kind", map.kind, mapKindNames,
              "Which maps lights get: six faces of a cube around lamps and one map for suns, or "
              "cascades for suns, or two paraboloids around lamps, or for suns one that is warped "
              "for what is visible (cube)");
    noted(verb.get_option("--map-kind"), settings.mapOptions);
    addChoice(verb, "--warp", map.warp, warpNames,
              "How maps of --map-kind warped are: by widths of columns and heights of rows, or in "
              "each row and column by itself (rectilinear)");
    noted(verb.get_option("--warp"), settings.mapOptions);
    add("--cascades", map.cascades,
        "Maps of each sun, of what is near the eye and farther off, 1 to 4 (4)")
        ->check(CLI::Range(1, mostCascades))
        ->type_name("N");
    addChoice(verb, "--filter", settings.filter, filterNames,
              "What is made of a map's texels: one compared, or --pcf of them, Poisson taps, a "
              "variance map, an exponential map, a map of four moments, percentage-closer soft "
              "shadows (as --pcf and --soft say)");
    noted(verb.get_option("--filter"), settings.mapOptions);
    add("--pcf", map.pcf,
        "How wide maps are filtered, in texels; of --filter pcf N x N are compared: 1, 3, 5 or 7 "
        "(1: hard edges; of --filter pcf 3, of poisson, vsm, esm and msm 5)")
        ->check(CLI::IsMember({1, 3, 5, 7}))
        ->type_name("N");
    addChoice(
        verb, "--soft", map.soft, softNames,
        "What lights with an extent get of their maps: hard shadows of all of their points, "
        "added up, or of the map of their centre what --pcf filters or percentage-closer soft "
        "shadows (none)");
    noted(verb.get_option("--soft"), settings.mapOptions);
}

void addPrimitiveMapMemory(CLI::App& verb, DrawSettings& settings) {
    noted(
        verb.add_option(
            "--primitive-map-memory", settings.render.primitiveMap.mostBytes,
            "What primitive maps may take on the GPU, those of all lights together; a light's may "
            "take half of what those of lights that matter more leave, a coarser one is tried, "
            "then volumes are counted (134217728)"),
        settings.primitiveMapOptions)
        ->check(CLI::Range(std::size_t{1} << 16, std::size_t{1} << 32))
        ->type_name("BYTES");
}

void addShadingOptions(CLI::App& verb, DrawSettings& settings) {
    addChoice(verb, "--shading", settings.render.shading, shadingNames,
              "What surfaces are drawn with: all that their materials say, or base colour and "
              "Lambert's law (full)");
    addChoice(verb, "--terminator", settings.render.softTerminator, terminatorNames,
              "Where light grazes smooth surfaces: dimmed until their facets turn away, or as "
              "bright as normals say up to there (exact)");
    noted(verb.get_option("--terminator"), settings.fullOptions);
    noted(verb.add_option(
              "--exposure", settings.render.exposure,
              "Light is taken 2^EV times before the display's colours are made of it (0)"),
          settings.fullOptions)
        ->check(finite())
        ->check(CLI::Range(-20.0, 20.0))
        ->type_name("EV");
}

void addEnvironment(CLI::App& verb, DrawSettings& settings) {
    noted(verb.add_option_function<std::string>(
              "--environment",
              [&settings](const std::string& file) {
                  settings.environment = file;
                  settings.render.environment.reset();
              },
              "What ambient light is and metals reflect: an equirectangular Radiance picture whose "
              "middle looks along -Z, taken as bright on average as --ambient says (a neutral sky "
              "and ground)"),
          settings.fullOptions)
        ->type_name("FILE.hdr");
}

void addVolumeOptions(CLI::App& verb, DrawSettings& settings) {
    addChoice(
        verb, "--mask-scale", settings.render.maskScale, maskScaleNames,
        "Resolution at which volumes are counted, as a share of the picture's; less is faster "
        "and less exact (1)");
    noted(verb.get_option("--mask-scale"), settings.volumeOptions);
}

void addRivalOptions(CLI::App& verb, DrawSettings& settings) {
    addChoice(verb, "--count", settings.count, countNames,
              "Which part of brute-force volumes is counted: what is behind surfaces, or what is "
              "before them and, by the light's own view of it, before the near plane (z-fail)");
    noted(verb.add_option("--planes", settings.render.planes,
                          "Onto how many planes shadows are projected, the largest of the scene, 1 "
                          "to " +
                              std::to_string(mostShadowPlanes) + " (4)"),
          settings.planarOptions)
        ->check(CLI::Range(std::size_t{1}, mostShadowPlanes))
        ->type_name("N");
}

/// Resolves options that only brute force and planar shadows have.
void resolveRivals(DrawSettings& settings) {
    const bool bruteForce = volumeLayoutOf(settings.render.multiplicity) == VolumeLayout::triangles;
    if (settings.count && !bruteForce)
        throw Error(ExitStatus::usage, "--count needs --layout brute-force.");
    settings.render.count = settings.count.value_or(BruteForceCount::zFail);
    if (bruteForce && settings.instancing == InstancingChoice::multiDraw)
        throw Error(
            ExitStatus::usage,
            "--instancing multi-draw does not go with --layout brute-force, whose triangles "
            "are drawn whole.");
    if (settings.render.shadows != ShadowMethod::planar && !settings.planarOptions.empty())
        throw Error(ExitStatus::usage, settings.planarOptions.front() + " needs --shadows planar.");
}

/// The default method for a layout.
MultiplicityMethod methodFor(std::optional<VolumeLayout> layout) {
    if (layout == VolumeLayout::oppositeVertices) return MultiplicityMethod::referenceEdge;
    return layout == VolumeLayout::triangles ? MultiplicityMethod::triangle
                                             : MultiplicityMethod::plane;
}

/// Sets the filter in ShadowMapSettings, and its default width if none was typed.
void resolveFilter(DrawSettings& settings) {
    ShadowMapSettings& map = settings.render.map;
    if (!settings.filter) return;
    const FilterChoice choice = *settings.filter;
    const std::string typed = "--filter " + nameIn(filterNames, choice);
    const bool pcss = choice == FilterChoice::pcss;
    if (settings.typedOfMaps("--soft") && (map.soft == SoftShadows::pcss) != pcss)
        throw Error(ExitStatus::usage,
                    typed + " does not go with --soft " + nameIn(softNames, map.soft) + ".");
    map.filter = choice == FilterChoice::poisson ? MapFilter::poisson
                 : choice == FilterChoice::vsm   ? MapFilter::variance
                 : choice == FilterChoice::esm   ? MapFilter::exponential
                 : choice == FilterChoice::msm   ? MapFilter::moments
                                                 : MapFilter::compare;
    if (pcss)
        map.soft = SoftShadows::pcss;
    else if (map.soft == SoftShadows::pcss)
        map.soft = SoftShadows::none; // left over from the base of a setting
    const bool one = choice == FilterChoice::none;
    if (!settings.typedOfMaps("--pcf"))
        map.pcf = one || pcss ? 1 : choice == FilterChoice::pcf ? 3 : 5;
    if (one && map.pcf > 1)
        throw Error(ExitStatus::usage, "--pcf " + std::to_string(map.pcf) +
                                           " does not go with --filter none, which compares one "
                                           "texel.");
}

void resolveMap(DrawSettings& settings) {
    resolveFilter(settings);
    const ShadowMapSettings& map = settings.render.map;
    const std::string soft = "Percentage-closer soft shadows (--soft pcss)";
    if (map.soft == SoftShadows::pcss && map.filter != MapFilter::compare)
        throw Error(ExitStatus::usage, soft + " need texels that are compared: --filter pcss.");
    if (map.soft == SoftShadows::pcss && map.kind != MapKind::cube)
        throw Error(ExitStatus::usage, soft + " need --map-kind cube.");
    if (settings.typedOfMaps("--cascades") && map.kind != MapKind::cascades)
        throw Error(ExitStatus::usage, "--cascades needs --map-kind cascades.");
    if (settings.typedOfMaps("--warp") && map.kind != MapKind::warped)
        throw Error(ExitStatus::usage, "--warp needs --map-kind warped.");
}

} // namespace

bool DrawSettings::typedOfMaps(const std::string& option) const {
    return std::find(mapOptions.begin(), mapOptions.end(), option) != mapOptions.end();
}

void addDrawOptions(CLI::App& verb, DrawSettings& settings) {
    addChoice(
        verb, "--shadows", settings.render.shadows, shadowWords,
        "How shadows are made. volumes: counted in the stencil. lookup (or primitive-map): lights "
        "at rest are looked up in a primitive map, exactly. points (or irregular-z-buffer): where "
        "the processor draws, it asks of each visible point whether it is in shadow. auto: lookup "
        "where a light rests and it pays, else points or volumes, whichever costs less. planar: "
        "projected onto the scene's largest planes, exact there and absent elsewhere (" +
            nameIn(shadowWords, settings.render.shadows) + ")",
        shadowNames);
    addMapOptions(verb, settings);
    addChoice(verb, "--multiplicity", settings.multiplicity, multiplicityNames,
              "How a triangle's facing is decided (plane; reference-edge with --layout published, "
              "triangle with brute-force); single-edge is not robust");
    addChoice(
        verb, "--layout", settings.layout, layoutNames,
        "What volumes are drawn from: records of what the scene requires, which hold planes, "
        "the published ones of opposite vertices, or casting triangles, each with a volume of "
        "its own (adapted)");
    addChoice(
        verb, "--silhouette", settings.silhouette, silhouetteNames,
        "Which plane-pair records reach the vertex shader: those that can be silhouettes in this "
        "light, or all of them (proposed)");
    addVolumeOptions(verb, settings);
    addRivalOptions(verb, settings);
    addChoice(
        verb, "--instancing", settings.instancing, instancingNames,
        "A record an instance, a copy for every vertex, or one draw a side, as plane-pair records "
        "always have (on where the GL can)");
    verb.add_option_function<std::string>(
            "--depth-slices",
            [&settings](const std::string& text) {
                if (text == "auto") return settings.depthSlices.reset();
                char* end = nullptr;
                const long count = std::strtol(text.c_str(), &end, 10);
                if (end == text.c_str() || *end != '\0' || count < 1 || count > 64)
                    throw CLI::ValidationError("--depth-slices",
                                               "'" + text +
                                                   "' is neither auto nor a number from 1 to 64");
                settings.depthSlices = static_cast<int>(count);
            },
            "Parts of the view by depth, each with a depth range of its own (auto: as many as "
            "pay)")
        ->type_name("N|auto");
    noted(verb.add_option("--light-samples", settings.render.lightSamples,
                          "Points of each light that has an extent, 1 to " +
                              std::to_string(mostLightPoints) +
                              ": its shadow is exact for each (64)"),
          settings.extentOptions)
        ->check(CLI::Range(std::size_t{1}, mostLightPoints))
        ->type_name("N");
    addPrimitiveMapMemory(verb, settings);
    verb.add_option_function<std::size_t>(
            "--shadowed-lights",
            [&settings](std::size_t most) {
                settings.render.shadowedLights = most;
                settings.typedShadowedLights = true;
            },
            "How many lights have shadows, 0 to " + std::to_string(mostLights) +
                ": those that are estimated to add most to the picture; the others shine through "
                "what casts (all)")
        ->check(CLI::Range(std::size_t{0}, mostLights))
        ->type_name("N");
    addShadingOptions(verb, settings);
    addEnvironment(verb, settings);
    verb.add_option("--ambient", settings.ambient,
                    "Share of ambient light, as the display shows it; the lights share the rest "
                    "(0.45; 0.35 with --shading base)")
        ->check(finite())
        ->check(CLI::Range(0.0, 1.0))
        ->type_name("0..1");
}

void resolve(DrawSettings& settings) {
    const bool full = settings.render.shading == Shading::full;
    settings.render.ambient = settings.ambient.value_or(full ? 0.45f : 0.35f);
    if (!full) settings.render.environment.reset();
    if (full && !settings.environment.empty() && !settings.render.environment)
        settings.render.environment =
            std::make_shared<const Environment>(readEnvironment(settings.environment));
    if (!full && !settings.fullOptions.empty())
        throw Error(ExitStatus::usage, settings.fullOptions.front() + " needs --shading full.");
    MultiplicityMethod& method = settings.render.multiplicity;
    method = settings.multiplicity.value_or(methodFor(settings.layout));
    if (settings.layout && volumeLayoutOf(method) != *settings.layout)
        throw Error(ExitStatus::usage, std::string("--multiplicity ") +
                                           nameIn(multiplicityNames, method) + " needs --layout " +
                                           nameIn(layoutNames, volumeLayoutOf(method)) + ".");
    const bool planes = volumeLayoutOf(method) == VolumeLayout::planePairs;
    if (!planes && settings.silhouette == SilhouetteChoice::proposed)
        throw Error(ExitStatus::usage, "--silhouette proposed needs --layout adapted.");
    for (const std::string& option : settings.volumeOptions)
        if (!planes && option != "--mask-scale")
            throw Error(ExitStatus::usage, option + " needs --layout adapted.");
    settings.render.silhouette =
        settings.silhouette.value_or(planes ? SilhouetteChoice::proposed : SilhouetteChoice::all);
    if (settings.render.shadows != ShadowMethod::map && !settings.mapOptions.empty())
        throw Error(ExitStatus::usage, settings.mapOptions.front() + " needs --shadows map.");
    if (settings.render.shadows == ShadowMethod::none && settings.typedShadowedLights)
        throw Error(ExitStatus::usage,
                    "--shadowed-lights does not go with --shadows none, where none has any.");
    resolveMap(settings);
    resolveRivals(settings);
    if (settings.render.shadows == ShadowMethod::automatic && !settings.volumeOptions.empty())
        settings.render.shadows = ShadowMethod::volumes;
    if (!settings.render.looksUpPrimitives() && !settings.primitiveMapOptions.empty())
        throw Error(ExitStatus::usage, settings.primitiveMapOptions.front() +
                                           " needs --shadows primitive-map or auto.");
    if (settings.render.shadows != ShadowMethod::volumes && !settings.volumeOptions.empty())
        throw Error(ExitStatus::usage,
                    settings.volumeOptions.front() + " needs --shadows volumes.");
}

void requireExtents(const DrawSettings& settings, std::span<const Light> lights) {
    const SoftShadows choice = settings.render.map.soft;
    const bool soft = choice != SoftShadows::none;
    if (settings.extentOptions.empty() && !soft) return;
    if (std::ranges::any_of(lights, [](const Light& light) { return light.extent.has_value(); }))
        return;
    throw Error(ExitStatus::usage, (settings.filter == FilterChoice::pcss ? "--filter pcss"
                                    : soft ? "--soft " + nameIn(softNames, choice)
                                           : settings.extentOptions.front()) +
                                       " needs a light with an extent: --light-radius, "
                                       "--light-size or --sun-angle.");
}

void requireMapKind(const DrawSettings& settings, std::span<const Light> lights) {
    const MapKind kind = settings.render.map.kind;
    if (settings.render.shadows != ShadowMethod::map || kind == MapKind::cube || lights.empty())
        return;
    const bool suns = kind != MapKind::paraboloid;
    if (std::ranges::any_of(lights,
                            [&](const Light& of) { return (of.position.w == 0.0) == suns; }))
        return;
    throw Error(ExitStatus::usage, "--map-kind " + nameIn(mapKindNames, kind) + " needs " +
                                       (suns ? "a sun." : "a lamp."));
}

DrawSettings settingsFrom(const DrawSettings& base, const std::string& text) {
    DrawSettings settings = base;
    settings.mapOptions.clear();
    settings.volumeOptions.clear();
    settings.primitiveMapOptions.clear();
    settings.fullOptions.clear();
    settings.extentOptions.clear();
    settings.planarOptions.clear();
    settings.typedShadowedLights = false;
    // Multiplicity or layout, whichever is typed here, decides the other.
    settings.multiplicity.reset();
    settings.layout.reset();
    settings.silhouette.reset();
    settings.count.reset();
    CLI::App parser;
    parser.set_help_flag();
    addDrawOptions(parser, settings);
    addCasterChanges(parser, settings.casters);
    std::vector<std::string> words;
    std::istringstream parts(text);
    for (std::string part; std::getline(parts, part, ',');) {
        const std::size_t equals = part.find('=');
        if (equals == std::string::npos || equals == 0)
            throw Error(ExitStatus::usage,
                        "--against: '" + part + "' is not of the form name=value.");
        words.push_back("--" + part.substr(0, equals));
        words.push_back(part.substr(equals + 1));
    }
    std::reverse(words.begin(), words.end()); // the order that CLI11 expects
    try {
        parser.parse(words);
    } catch (const CLI::ExtrasError& error) {
        throw Error(ExitStatus::usage,
                    "--against " + text + ": " + unknownOption(parser, parser.remaining(), error));
    } catch (const CLI::ParseError& error) {
        throw Error(ExitStatus::usage, "--against " + text + ": " + error.what() + ".");
    }
    if (!settings.multiplicity && !settings.layout) {
        settings.multiplicity = base.multiplicity;
        settings.layout = base.layout;
        if (!settings.silhouette) settings.silhouette = base.silhouette;
        if (!settings.count) settings.count = base.count;
    }
    resolve(settings);
    return settings;
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

std::string shortName(const DrawSettings& settings) {
    const RenderSettings& render = settings.render;
    std::string name = nameIn(shadowNames, render.shadows);
    if (render.shadows == ShadowMethod::map) name += " " + std::to_string(render.map.size);
    if (render.shadows == ShadowMethod::map && render.map.kind != MapKind::cube)
        name +=
            ", " + nameIn(mapKindNames, render.map.kind) +
            (render.map.kind == MapKind::warped ? " " + nameIn(warpNames, render.map.warp) : "");
    if (render.shadows == ShadowMethod::map && render.map.filter != MapFilter::compare)
        name += ", " + nameIn(filterNames, filterOf(render.map));
    if (render.shadows == ShadowMethod::map && render.map.soft != SoftShadows::none)
        name += ", " + nameIn(softNames, render.map.soft);
    if (render.shadows == ShadowMethod::planar) name += " " + std::to_string(render.planes);
    if (render.shadows == ShadowMethod::volumes &&
        volumeLayoutOf(render.multiplicity) == VolumeLayout::triangles)
        name += ", brute force " + nameIn(countNames, render.count);
    if (render.shadows == ShadowMethod::volumes && render.maskScale > 1)
        name += ", mask " + nameIn(maskScaleNames, render.maskScale);
    if (render.shadowedLights && render.shadows != ShadowMethod::none)
        name += ", of " + std::to_string(*render.shadowedLights) + " lights";
    return name;
}

nlohmann::ordered_json settingsJson(const DrawSettings& settings) {
    const RenderSettings& render = settings.render;
    nlohmann::ordered_json json = {
        {"shadows", nameIn(shadowNames, render.shadows)},
        {"layout", nameIn(layoutNames, volumeLayoutOf(render.multiplicity))},
        {"multiplicity", nameIn(multiplicityNames, render.multiplicity)},
        {"silhouette", nameIn(silhouetteNames, render.silhouette)},
        {"instancing", nameIn(instancingNames, settings.instancing)},
        {"depth-slices", settings.depthSlices ? nlohmann::ordered_json(*settings.depthSlices)
                                              : nlohmann::ordered_json("auto")},
        {"shadowed-lights", render.shadowedLights ? nlohmann::ordered_json(*render.shadowedLights)
                                                  : nlohmann::ordered_json("all")},
        {"light-samples", render.lightSamples},
        {"shading", nameIn(shadingNames, render.shading)},
        {"ambient", render.ambient}};
    if (render.shading == Shading::full) {
        json["exposure"] = render.exposure;
        json["terminator"] = nameIn(terminatorNames, render.softTerminator);
        json["environment"] = settings.environment.empty() ? "neutral" : settings.environment;
    }
    if (volumeLayoutOf(render.multiplicity) == VolumeLayout::triangles)
        json["count"] = nameIn(countNames, render.count);
    if (render.shadows == ShadowMethod::planar) json["planes"] = render.planes;
    if (render.shadows == ShadowMethod::volumes)
        json["mask-scale"] = nameIn(maskScaleNames, render.maskScale);
    if (render.shadows == ShadowMethod::map)
        json.update({{"map-size", render.map.size},
                     {"map-bias", render.map.biasTexels},
                     {"map-kind", nameIn(mapKindNames, render.map.kind)},
                     {"filter", nameIn(filterNames, filterOf(render.map))},
                     {"pcf", render.map.pcf},
                     {"soft", nameIn(softNames, render.map.soft)}});
    if (render.shadows == ShadowMethod::map && render.map.kind == MapKind::cascades)
        json["cascades"] = render.map.cascades;
    if (render.shadows == ShadowMethod::map && render.map.kind == MapKind::warped)
        json["warp"] = nameIn(warpNames, render.map.warp);
    if (render.looksUpPrimitives()) json["primitive-map-memory"] = render.primitiveMap.mostBytes;
    return json;
}

nlohmann::ordered_json methodsJson(const std::vector<LightMethod>& methods) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const LightMethod& of : methods)
        json.push_back({{"method", of.method},
                        {"why", of.why},
                        {"build_ms", of.buildMs},
                        {"bytes", of.bytes}});
    return json;
}

std::vector<std::string> fallbackWarnings(ShadowMethod asked,
                                          const std::vector<LightMethod>& methods) {
    std::vector<std::string> warnings;
    if (asked != ShadowMethod::primitiveMap) return warnings;
    for (std::size_t i = 0; i < methods.size(); ++i)
        if (methods[i].method != "primitive-map" && methods[i].method != "none")
            warnings.push_back("Light " + std::to_string(i) +
                               ": --shadows primitive-map is not for it: " + methods[i].why +
                               ". Its shadows are those of " + methods[i].method + ".");
    return warnings;
}

nlohmann::ordered_json deviceJson(const gl::Capabilities& capabilities) {
    return {{"vendor", capabilities.vendor},
            {"renderer", capabilities.renderer},
            {"version", capabilities.version},
            {"depth_bits", capabilities.depthBits},
            {"subpixel_bits", capabilities.subpixelBits},
            {"stencil_bits", capabilities.stencilBits},
            {"extensions", capabilities.extensions},
            {"vertex_mantissa_bits", capabilities.vertexHighpMantissaBits},
            {"fragment_mantissa_bits", capabilities.fragmentHighpMantissaBits},
            {"vertex_attributes", capabilities.vertexAttributes},
            {"texture_units", capabilities.textureUnits},
            {"varying_vectors", capabilities.varyingVectors},
            {"vertex_uniform_vectors", capabilities.vertexUniformVectors},
            {"fragment_uniform_vectors", capabilities.fragmentUniformVectors},
            {"texture_size", capabilities.largestTexture},
            {"instancing", capabilities.instancing.has_value()},
            {"gl_limits", glLimitsName(capabilities.limits)}};
}

} // namespace edgeshade::cli
