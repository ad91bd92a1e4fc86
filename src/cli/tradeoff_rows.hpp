#pragma once

#include "src/bench/bench.hpp"
#include "src/bench/halving.hpp"
#include "src/cli/draw_settings.hpp"
#include "src/cli/tradeoff_options.hpp"
#include "src/cli/tradeoff_settings.hpp"

namespace edgeshade::cli {

/// A setting with what it costs and what it gets wrong.
struct TradeRow {
    TradeSetting setting; ///< with the bias that was tuned
    DrawSettings settings;
    std::shared_ptr<const LoadedScene> scene; ///< with their casters; null: the call's own
    CasterSettings casters;
    std::string callsOptions; ///< of the call's casters, as far as the setting leaves them
    std::size_t bytes = 0;    ///< on the GPU, of shadows alone
    bench::Standing standing;
    bench::Estimate estimate;
    bool pareto = false;

    bool isDropped() const { return standing.dominator.has_value(); }
    /// What draws like it, as any verb takes it.
    std::string options() const { return asOptions(setting.text) + callsOptions; }
};

/// The settings that this GL can draw, not yet measured; what it can't is left out with a warning.
std::vector<TradeRow> possibleRows(const TradeoffOptions& options, const LoadedScene& loaded,
                                   std::vector<std::string>& warnings);

} // namespace edgeshade::cli
