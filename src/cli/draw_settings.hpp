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

/// What --filter names: one texel, or MapFilter's, or SoftShadows::pcss.
enum class FilterChoice { none, pcf, poisson, vsm, esm, msm, pcss };

/// How pictures are drawn, as typed: what `--against` can vary.
struct DrawSettings {
    DrawSettings() {
        render.shading = Shading::full;
        render.rivals = &allRivals();
    }

    RenderSettings render;
    std::optional<MultiplicityMethod> multiplicity; ///< as typed; see resolve()
    std::optional<VolumeLayout> layout;             ///< likewise
    std::optional<SilhouetteChoice> silhouette;     ///< likewise
    std::optional<BruteForceCount> count;           ///< likewise
    InstancingChoice instancing = InstancingChoice::automatic;
    std::optional<int> depthSlices;               ///< nothing: as many as pay
    std::optional<float> ambient;                 ///< as typed; see resolve()
    std::optional<FilterChoice> filter;           ///< likewise
    std::string environment;                      ///< a file; see resolve()
    std::vector<std::string> fullOptions;         ///< those that only full shading has
    std::vector<std::string> mapOptions;          ///< those typed that only shadow maps have
    std::vector<std::string> volumeOptions;       ///< those that only shadow volumes have
    std::vector<std::string> primitiveMapOptions; ///< those that only primitive maps have
    bool typedShadowedLights = false;             ///< --shadowed-lights was
    std::vector<std::string> extentOptions;       ///< those that only lights with an extent have
    std::vector<std::string> planarOptions;       ///< those that only planar shadows have
    CasterChanges casters;                        ///< of `--against`: on top of the call's own

    bool hasMapBias() const { return typedOfMaps("--map-bias"); }
    /// Whether an option that only shadow maps have was typed.
    bool typedOfMaps(const std::string& option) const;
};

/// Adds the options; `settings` must outlive parsing.
void addDrawOptions(CLI::App& verb, DrawSettings& settings);

/// Reads the environment, and works out render.ambient, render.multiplicity and render.silhouette
/// from what was typed: plane-pair records hold planes, published ones opposite vertices, brute
/// force needs neither, so that layout or method follows from the other. Throws Error(usage) where
/// they don't go together, and for options that another one makes meaningless; InputError.
void resolve(DrawSettings& settings);

/// Throws Error(usage) where there is an option or a choice that only lights with an extent have,
/// and none of these has one.
void requireExtents(const DrawSettings& settings, std::span<const Light> lights);

/// Throws Error(usage) where there is a kind of map that none of these lights gets. None at all:
/// not known, and any kind may be.
void requireMapKind(const DrawSettings& settings, std::span<const Light> lights);

/// "name=value,name=value" on top of `base`, names without dashes, e.g. "shadows=map,map-size=512",
/// casters' too, e.g. "caster-error=0.01".
/// Throws Error(usage).
DrawSettings settingsFrom(const DrawSettings& base, const std::string& text);

/// What of materials has to be read for all of them. `settingsOf`: a member that has them.
template <class Items, class Member = std::identity>
Shading shadingFor(const Items& items, Member settingsOf = {}) {
    const auto isFull = [](const DrawSettings& one) { return one.render.shading == Shading::full; };
    return std::ranges::any_of(items, isFull, settingsOf) ? Shading::full : Shading::base;
}

/// Whether some of them draw volumes from what doesn't tell fronts from backs: opposite-vertex
/// records and triangles by themselves. `settingsOf`: as above.
template <class Items, class Member = std::identity>
bool drawOppositeVertices(const Items& items, Member settingsOf = {}) {
    const auto does = [](const DrawSettings& one) {
        const auto records = one.render.records();
        return records && records->volumes != VolumeLayout::planePairs;
    };
    return std::ranges::any_of(items, does, settingsOf);
}

/// The layout that the choice means in this context.
SidesLayout layoutFor(InstancingChoice choice, const gl::Capabilities& capabilities);

/// What tells the settings apart at a glance: "volumes", "volumes, mask 1/2", "map 2048", "none".
std::string shortName(const DrawSettings& settings);

/// The settings as report keys, by the options' names.
nlohmann::ordered_json settingsJson(const DrawSettings& settings);

/// A sentence for each light that gets other shadows than were asked for by name.
std::vector<std::string> fallbackWarnings(ShadowMethod asked,
                                          const std::vector<LightMethod>& methods);

/// [{method, why, build_ms, bytes}, ...] of lights.
nlohmann::ordered_json methodsJson(const std::vector<LightMethod>& methods);

/// The settings' like of a device.
nlohmann::ordered_json deviceJson(const gl::Capabilities& capabilities);

} // namespace edgeshade::cli
