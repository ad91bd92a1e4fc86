#pragma once

#include "src/cli/options.hpp"
#include "src/render/frame/frame.hpp"
#include "src/render/frame/light_methods.hpp"
#include "src/rivals/rivals.hpp"

#include <algorithm>
#include <CLI/CLI.hpp>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace edgeshade::cli {

enum class InstancingChoice { automatic, on, off, multiDraw };

/// The values of --filter: a single texel, those of MapFilter, or SoftShadows::pcss.
enum class FilterChoice { none, pcf, poisson, vsm, esm, msm, pcss };

/// How pictures are drawn, as typed: the settings that `--against` can vary.
struct DrawSettings {
    DrawSettings() {
        render.shading = Shading::full;
        render.rivals = &allRivals();
    }

    RenderSettings render;
    std::optional<MultiplicityMethod> multiplicity; ///< as typed; see resolve()
    std::optional<VolumeLayout> layout;             ///< as typed; see resolve()
    std::optional<SilhouetteChoice> silhouette;     ///< as typed; see resolve()
    std::optional<BruteForceCount> count;           ///< as typed; see resolve()
    InstancingChoice instancing = InstancingChoice::automatic;
    std::optional<int> depthSlices;               ///< null: as many as pay
    std::optional<float> ambient;                 ///< as typed; see resolve()
    std::optional<FilterChoice> filter;           ///< as typed; see resolve()
    std::string environment;                      ///< a file; see resolve()
    std::vector<std::string> fullOptions;         ///< typed options that only full shading has
    std::vector<std::string> mapOptions;          ///< typed options that only shadow maps have
    std::vector<std::string> volumeOptions;       ///< typed options that only shadow volumes have
    std::vector<std::string> primitiveMapOptions; ///< typed options that only primitive maps have
    bool typedShadowedLights = false;             ///< --shadowed-lights was typed
    std::vector<std::string> extentOptions;       ///< typed options that only lights with an extent
                                                  ///< have
    std::vector<std::string> planarOptions;       ///< typed options that only planar shadows have
    CasterChanges casters;                        ///< from `--against`: in addition to the call's
                                                  ///< own

    bool hasMapBias() const { return typedOfMaps("--map-bias"); }
    /// Whether this option, which only shadow maps have, was typed.
    bool typedOfMaps(const std::string& option) const;
};

/// Adds the options; `settings` must outlive parsing.
void addDrawOptions(CLI::App& verb, DrawSettings& settings);

/// Reads the environment, and derives render.ambient, render.multiplicity and render.silhouette
/// from the typed options. Plane-pair records hold planes, published ones opposite vertices, and
/// brute force needs neither, so layout and method follow from each other. Throws Error(usage) for
/// options that don't go together or that another one makes meaningless; InputError.
void resolve(DrawSettings& settings);

/// Throws Error(usage) if an option or a choice needs lights with an extent, and none of these has
/// one.
void requireExtents(const DrawSettings& settings, std::span<const Light> lights);

/// Throws Error(usage) if none of these lights can have the requested kind of map. An empty list
/// means that the lights are unknown, so any kind is allowed.
void requireMapKind(const DrawSettings& settings, std::span<const Light> lights);

/// Applies "name=value,name=value" to `base`. Names are options without dashes, e.g.
/// "shadows=map,map-size=512", including caster options, e.g. "caster-error=0.01". Throws
/// Error(usage).
DrawSettings settingsFrom(const DrawSettings& base, const std::string& text);

/// The shading for which materials must be read, to suit all items. `settingsOf`: the member with
/// an item's settings.
template <class Items, class Member = std::identity>
Shading shadingFor(const Items& items, Member settingsOf = {}) {
    const auto isFull = [](const DrawSettings& one) { return one.render.shading == Shading::full; };
    return std::ranges::any_of(items, isFull, settingsOf) ? Shading::full : Shading::base;
}

/// Whether any item draws volumes from records that don't distinguish fronts from backs:
/// opposite-vertex records or single triangles. `settingsOf`: as above.
template <class Items, class Member = std::identity>
bool drawOppositeVertices(const Items& items, Member settingsOf = {}) {
    const auto does = [](const DrawSettings& one) {
        const auto records = one.render.records();
        return records && records->volumes != VolumeLayout::planePairs;
    };
    return std::ranges::any_of(items, does, settingsOf);
}

/// The layout for the choice in this context.
SidesLayout layoutFor(InstancingChoice choice, const gl::Capabilities& capabilities);

/// A short name that identifies the settings: "volumes", "volumes, mask 1/2", "map 2048", "none".
std::string shortName(const DrawSettings& settings);

/// The settings as report keys, named like the options.
nlohmann::ordered_json settingsJson(const DrawSettings& settings);

/// A sentence for each light whose shadows differ from the method requested by name.
std::vector<std::string> fallbackWarnings(ShadowMethod asked,
                                          const std::vector<LightMethod>& methods);

/// The lights' [{method, why, build_ms, bytes}, ...].
nlohmann::ordered_json methodsJson(const std::vector<LightMethod>& methods);

/// A device as report keys.
nlohmann::ordered_json deviceJson(const gl::Capabilities& capabilities);

} // namespace edgeshade::cli
