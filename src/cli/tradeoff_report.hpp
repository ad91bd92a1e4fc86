#pragma once

#include "src/cli/tradeoff_measuring.hpp"

#include <nlohmann/json.hpp>

namespace edgeshade::cli {

/// A table of the rows, for people.
std::string tableOf(const std::vector<TradeRow>& rows);

/// The contract's keys of a row, and how much was measured of it. `rows`: all of them.
nlohmann::ordered_json rowJson(const TradeRow& row, const std::vector<TradeRow>& rows);

/// Throws Error(usage) for a path that ends neither in .svg nor in .png, Error(unavailable) where
/// the program can't write the latter. An empty one is none.
void requirePlottable(const std::string& path);

/// Draws the rows to where the options say, if they say. Throws Error(output).
void writeTradePlot(const TradeoffOptions& options, const std::vector<TradeRow>& rows,
                    const TradeMeasuring& measuring);

} // namespace edgeshade::cli
