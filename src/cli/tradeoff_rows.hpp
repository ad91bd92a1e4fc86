#pragma once

#include "src/bench/bench.hpp"
#include "src/bench/halving.hpp"
#include "src/cli/draw_settings.hpp"
#include "src/cli/tradeoff_options.hpp"
#include "src/cli/tradeoff_settings.hpp"

namespace edgeshade::cli {

/// A setting with its cost and its errors.
struct TradeRow {
    TradeSetting setting; ///< with the tuned bias
    DrawSettings settings;
    std::shared_ptr<const LoadedScene> scene; ///< the scene with the setting's casters; null: the
                                              ///< call's own
    CasterSettings casters;
    std::string callsOptions; ///< the call's caster options that the setting doesn't change
    std::size_t bytes = 0;    ///< on the GPU, for shadows alone
    bench::Standing standing;
    bench::Estimate estimate;
    bool pareto = false;

    bool isDropped() const { return standing.dominator.has_value(); }
    /// Options that draw the same with any verb.
    std::string options() const { return asOptions(setting.text) + callsOptions; }
};

/// The settings that this GL can draw, not yet measured; adds a warning for each that it can't.
std::vector<TradeRow> possibleRows(const TradeoffOptions& options, const LoadedScene& loaded,
                                   std::vector<std::string>& warnings);

} // namespace edgeshade::cli
