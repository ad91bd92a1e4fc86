#pragma once

#include "src/cli/draw_settings.hpp"

namespace edgeshade::cli {

/// A setting that `tradeoff` weighs.
struct TradeSetting {
    std::string name; ///< short, for the plot
    std::string text; ///< as `--against` takes it
};

/// The settings that there are to choose from: what users turn when they trade time for accuracy.
/// One more setting is one more entry. `largestMap`: texels; larger maps are left out.
std::vector<TradeSetting> tradeSettings(int largestMap);

/// "shadows=map,map-size=512" as "--shadows map --map-size 512".
std::string asOptions(const std::string& text);

} // namespace edgeshade::cli
