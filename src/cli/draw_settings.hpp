#pragma once

#include "src/cli/options.hpp"
#include "src/cli/setting_text.hpp"
#include "src/render/frame/frame.hpp"
#include "src/render/frame/light_methods.hpp"
#include "src/rivals/rivals.hpp"

#include <algorithm>
#include <CLI/CLI.hpp>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace edgeshade::cli {

/// How pictures are drawn, as typed: what `--against` can vary.
struct DrawSettings {
    DrawSettings() {
        render.shading = Shading::full;
        render.rivals = &allRivals();
    }

    RenderSettings render;
    VolumeLayout layout = VolumeLayout::planePairs; ///< that of render.multiplicity, see resolve()
    InstancingChoice instancing = InstancingChoice::automatic;
    std::optional<int> depthSlices;                                    ///< nothing: as many as pay
    FilterChoice filter{MapFilter::compare, FilterChoice::Width::one}; ///< see resolve()
    std::string environment;     ///< a file; empty: the neutral one
    std::set<std::string> typed; ///< names of options, of `--against` its own alone
    bool ambientTyped = false;   ///< here, or in what this is on top of
    CasterChanges casters;       ///< of `--against`: on top of the call's own

    bool has(const std::string& option) const { return typed.count(option) > 0; }
};

/// Calls use(setting, value...) for every setting, in the order of reports. `of`: DrawSettings,
/// constant or not.
template <class Use, class... Of>
void forEachSetting(Use use, Of&... of) {
    use(settings::shadows, of.render.shadows...);
    use(settings::layout, of.layout...);
    use(settings::multiplicity, of.render.multiplicity...);
    use(settings::silhouette, of.render.silhouette...);
    use(settings::instancing, of.instancing...);
    use(settings::depthSlices, of.depthSlices...);
    use(settings::shadowedLights, of.render.shadowedLights...);
    use(settings::lightSamples, of.render.lightSamples...);
    use(settings::shading, of.render.shading...);
    use(settings::ambient, of.render.ambient...);
    use(settings::exposure, of.render.exposure...);
    use(settings::terminator, of.render.softTerminator...);
    use(settings::environment, of.environment...);
    use(settings::count, of.render.count...);
    use(settings::planes, of.render.planes...);
    use(settings::maskScale, of.render.maskScale...);
    use(settings::mapSize, of.render.map.size...);
    use(settings::mapBias, of.render.map.biasTexels...);
    use(settings::mapKind, of.render.map.kind...);
    use(settings::filter, of.filter...);
    use(settings::pcf, of.render.map.pcf...);
    use(settings::soft, of.render.map.soft...);
    use(settings::cascades, of.render.map.cascades...);
    use(settings::warp, of.render.map.warp...);
    use(settings::primitiveMapMemory, of.render.primitiveMap.mostBytes...);
}

/// Adds the options; `settings` must outlive parsing.
void addDrawOptions(CLI::App& verb, DrawSettings& settings);

/// Reads the environment, and works out what follows from what was typed: the ambient light from
/// the shading, the filter's width from the filter, and layout, multiplicity and silhouettes from
/// each other. Plane-pair records hold planes, published ones opposite vertices, brute force needs
/// neither. Throws Error(usage) for settings that don't go together, and for options without an
/// effect; InputError.
void resolve(DrawSettings& settings);

/// Throws Error(usage) for an option or a choice that only lights with an extent have, if none of
/// these has one.
void requireExtents(const DrawSettings& settings, std::span<const Light> lights);

/// The first typed option that only lights with an extent have; empty: none.
std::string extentOption(const DrawSettings& settings);

/// Throws Error(usage) for a kind of map that none of these lights gets. Without lights any kind
/// passes.
void requireMapKind(const DrawSettings& settings, std::span<const Light> lights);

/// Applies "name=value,name=value" to `base`. Names are options without dashes, e.g.
/// "shadows=map,map-size=512", including caster options, e.g. "caster-error=0.01". Throws
/// Error(usage).
DrawSettings settingsFrom(const DrawSettings& base, const std::string& text);

/// The shading that covers all of them. `settingsOf`: a member that has them.
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

/// A short name: "volumes", "volumes, mask 1/2", "map 2048", "none".
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
