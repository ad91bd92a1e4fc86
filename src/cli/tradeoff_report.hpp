#pragma once

#include "src/cli/tradeoff_measuring.hpp"

#include <nlohmann/json.hpp>

namespace edgeshade::cli {

/// A table of the rows, for people.
std::string tableOf(const std::vector<TradeRow>& rows);

/// The JSON keys of a row's contract, and how much of it was measured. `rows`: all rows.
nlohmann::ordered_json rowJson(const TradeRow& row, const std::vector<TradeRow>& rows);

/// Throws Error(usage) for a path that ends neither in .svg nor in .png, and Error(unavailable) if
/// the program can't write PNG. An empty path means no plot.
void requirePlottable(const std::string& path);

/// Draws the rows to the path in the options, if there is one. Throws Error(output).
void writeTradePlot(const TradeoffOptions& options, const std::vector<TradeRow>& rows,
                    const TradeMeasuring& measuring);

} // namespace edgeshade::cli
