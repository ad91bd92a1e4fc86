#pragma once

#include "src/cli/draw_settings.hpp"

namespace edgeshade::cli {

/// A setting that `tradeoff` weighs.
struct TradeSetting {
    std::string name; ///< short, for the plot
    std::string text; ///< as `--against` takes it
};

/// The settings to choose from: those that users change to trade time for accuracy. Another setting
/// is another entry. `largestMap`: texels; larger maps are left out. `diagonal`: of the scene, in
/// scene units. `lights`: those that are timed; kinds of maps that none of them can have are left
/// out.
std::vector<TradeSetting> tradeSettings(int largestMap, double diagonal,
                                        std::span<const Light> lights);

/// "shadows=map,map-size=512" as "--shadows map --map-size 512".
std::string asOptions(const std::string& text);

/// Caster options of the call that a setting doesn't change: " --cast-masked --caster-error 0.01".
std::string leftOptions(const CasterOptions& call, const CasterChanges& setting);

} // namespace edgeshade::cli
