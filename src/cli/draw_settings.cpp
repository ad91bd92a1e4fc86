#include "src/cli/draw_settings.hpp"

#include "preprocess/base/error.hpp"
#include "src/cli/help.hpp"
#include "src/environment/reading.hpp"

#include <algorithm>
#include <sstream>

namespace edgeshade::cli {
namespace {

using Width = FilterChoice::Width;

template <class Domain, class Value>
std::string wordFor(const Setting<Domain>& setting, Value value) {
    return wordOf(setting.domain, value);
}

[[noreturn]] void fail(const std::string& sentence) {
    throw Error(ExitStatus::usage, sentence);
}

FilterChoice filterOf(const ShadowMapSettings& map) {
    if (map.filter != MapFilter::compare) return {map.filter};
    if (map.soft == SoftShadows::pcss) return {map.filter, Width::pcss};
    return {map.filter, map.pcf > 1 ? Width::several : Width::one};
}

/// The method that goes with a layout if none is typed.
MultiplicityMethod methodFor(VolumeLayout layout) {
    if (layout == VolumeLayout::oppositeVertices) return MultiplicityMethod::referenceEdge;
    return layout == VolumeLayout::triangles ? MultiplicityMethod::triangle
                                             : MultiplicityMethod::plane;
}

/// Layout, multiplicity, silhouettes and count from those of them that were typed. If there is a
/// layout or a multiplicity among these, it decides; else the others stay as they are.
void resolveRecords(DrawSettings& settings) {
    RenderSettings& render = settings.render;
    const bool layoutTyped = settings.has("--layout");
    const bool decides = layoutTyped || settings.has("--multiplicity");
    if (!settings.has("--multiplicity") && layoutTyped)
        render.multiplicity = methodFor(settings.layout);
    const VolumeLayout layout = volumeLayoutOf(render.multiplicity);
    if (layoutTyped && layout != settings.layout)
        fail("--multiplicity " + wordFor(settings::multiplicity, render.multiplicity) +
             " needs --layout " + wordFor(settings::layout, layout) + ".");
    settings.layout = layout;
    const bool planes = layout == VolumeLayout::planePairs;
    if (settings.has("--silhouette")) {
        if (!planes && render.silhouette == SilhouetteChoice::proposed)
            fail("--silhouette proposed needs --layout adapted.");
    } else if (decides) {
        render.silhouette = planes ? SilhouetteChoice::proposed : SilhouetteChoice::all;
    }
    if (decides && !settings.has("--count")) render.count = BruteForceCount::zFail;
    if (layout == VolumeLayout::triangles && settings.instancing == InstancingChoice::multiDraw)
        fail("--instancing multi-draw does not go with --layout brute-force, whose triangles are "
             "drawn whole.");
}

/// The filter that --filter names, and its width unless --pcf says it.
void resolveFilter(DrawSettings& settings) {
    ShadowMapSettings& map = settings.render.map;
    if (settings.has("--filter")) {
        const auto [filter, width] = settings.filter;
        const std::string typed = "--filter " + wordFor(settings::filter, settings.filter);
        const bool pcss = width == Width::pcss;
        if (settings.has("--soft") && (map.soft == SoftShadows::pcss) != pcss)
            fail(typed + " does not go with --soft " + wordFor(settings::soft, map.soft) + ".");
        map.filter = filter;
        if (pcss)
            map.soft = SoftShadows::pcss;
        else if (map.soft == SoftShadows::pcss)
            map.soft = SoftShadows::none; // of a setting on top of another
        if (!settings.has("--pcf"))
            map.pcf = width != Width::several ? 1 : filter == MapFilter::compare ? 3 : 5;
        if (width == Width::one && map.pcf > 1)
            fail("--pcf " + std::to_string(map.pcf) +
                 " does not go with --filter none, which "
                 "compares one texel.");
    }
    settings.filter = filterOf(map);
    const std::string soft = "Percentage-closer soft shadows (--soft pcss)";
    if (map.soft == SoftShadows::pcss && map.filter != MapFilter::compare)
        fail(soft + " need texels that are compared: --filter pcss.");
    if (map.soft == SoftShadows::pcss && map.kind != MapKind::cube)
        fail(soft + " need --map-kind cube.");
}

/// Every option that was typed has an effect.
void requireEffects(const DrawSettings& settings) {
    forEachSetting([&](const auto& setting) {
        const std::string option = optionNameOf(setting.key);
        const std::string needed = missing(setting.needs, settings.render);
        if (settings.has(option) && !needed.empty()) fail(option + " needs " + needed + ".");
    });
    if (settings.has("--shadowed-lights") && settings.render.shadows == ShadowMethod::none)
        fail("--shadowed-lights does not go with --shadows none, where none has any.");
}

} // namespace

void addDrawOptions(CLI::App& verb, DrawSettings& settings) {
    forEachSetting(
        [&](const auto& setting, auto& value) {
            addSetting(verb, setting, value)
                ->each([&settings, option = optionNameOf(setting.key)](const std::string&) {
                    settings.typed.insert(option);
                });
        },
        settings);
}

void resolve(DrawSettings& settings) {
    RenderSettings& render = settings.render;
    const bool full = render.shading == Shading::full;
    settings.ambientTyped |= settings.has("--ambient");
    if (!settings.ambientTyped) render.ambient = full ? 0.45f : 0.35f;
    if (render.shadows == ShadowMethod::automatic && settings.has("--mask-scale"))
        render.shadows = ShadowMethod::volumes;
    resolveRecords(settings);
    resolveFilter(settings);
    requireEffects(settings);
    if (!full || settings.has("--environment")) render.environment.reset();
    if (full && !settings.environment.empty() && !render.environment)
        render.environment =
            std::make_shared<const Environment>(readEnvironment(settings.environment));
}

std::string extentOption(const DrawSettings& settings) {
    for (const char* option : {"--light-samples", "--shade-samples"})
        if (settings.has(option)) return option;
    return "";
}

void requireExtents(const DrawSettings& settings, std::span<const Light> lights) {
    const SoftShadows soft = settings.render.map.soft;
    std::string option = extentOption(settings);
    if (soft != SoftShadows::none)
        option =
            settings.has("--filter") ? "--filter pcss" : "--soft " + wordFor(settings::soft, soft);
    if (option.empty() ||
        std::ranges::any_of(lights, [](const Light& light) { return light.extent.has_value(); }))
        return;
    fail(option + " needs a light with an extent: --light-radius, --light-size or --sun-angle.");
}

void requireMapKind(const DrawSettings& settings, std::span<const Light> lights) {
    const MapKind kind = settings.render.map.kind;
    if (settings.render.shadows != ShadowMethod::map || kind == MapKind::cube || lights.empty())
        return;
    const bool suns = kind != MapKind::paraboloid;
    if (std::ranges::any_of(lights,
                            [&](const Light& of) { return (of.position.w == 0.0) == suns; }))
        return;
    fail("--map-kind " + wordFor(settings::mapKind, kind) + " needs " +
         (suns ? "a sun." : "a lamp."));
}

DrawSettings settingsFrom(const DrawSettings& base, const std::string& text) {
    DrawSettings settings = base;
    settings.typed.clear();
    CLI::App parser;
    parser.set_help_flag();
    addDrawOptions(parser, settings);
    addCasterChanges(parser, settings.casters);
    std::vector<std::string> words;
    std::istringstream parts(text);
    for (std::string part; std::getline(parts, part, ',');) {
        const std::size_t equals = part.find('=');
        if (equals == std::string::npos || equals == 0)
            fail("--against: '" + part + "' is not of the form name=value.");
        words.push_back("--" + part.substr(0, equals));
        words.push_back(part.substr(equals + 1));
    }
    std::reverse(words.begin(), words.end()); // the order that CLI11 expects
    try {
        parser.parse(words);
    } catch (const CLI::ExtrasError& error) {
        fail("--against " + text + ": " + unknownOption(parser, parser.remaining(), error));
    } catch (const CLI::ParseError& error) {
        fail("--against " + text + ": " + error.what() + ".");
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
    std::string name = wordFor(settings::shadows, render.shadows);
    if (render.shadows == ShadowMethod::map) {
        name += " " + std::to_string(render.map.size);
        if (render.map.kind != MapKind::cube)
            name += ", " + wordFor(settings::mapKind, render.map.kind);
        if (render.map.kind == MapKind::warped)
            name += " " + wordFor(settings::warp, render.map.warp);
        if (render.map.filter != MapFilter::compare)
            name += ", " + wordFor(settings::filter, settings.filter);
        if (render.map.soft != SoftShadows::none)
            name += ", " + wordFor(settings::soft, render.map.soft);
    }
    if (render.shadows == ShadowMethod::planar) name += " " + std::to_string(render.planes);
    if (render.shadows == ShadowMethod::volumes) {
        if (settings.layout == VolumeLayout::triangles)
            name += ", brute force " + wordFor(settings::count, render.count);
        if (render.maskScale > 1)
            name += ", mask " + wordFor(settings::maskScale, render.maskScale);
    }
    if (render.shadowedLights && render.shadows != ShadowMethod::none)
        name += ", of " + std::to_string(*render.shadowedLights) + " lights";
    return name;
}

nlohmann::ordered_json settingsJson(const DrawSettings& settings) {
    nlohmann::ordered_json json;
    forEachSetting(
        [&](const auto& setting, const auto& value) {
            if (holds(setting.needs, settings.render))
                json[optionNameOf(setting.key).substr(2)] = written(setting.domain, value);
        },
        settings);
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
